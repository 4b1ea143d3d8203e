// SPDX-License-Identifier: MIT
#include "tools/reproduce/reproduce.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "refine/refine.h"
#include "tools/reproduce/data_files.h"
#include "tools/reproduce/figures.h"
#include "tools/reproduce/model_views.h"
#include "tools/reproduce/page.h"
#include "tools/reproduce/shaded_view.h"
#include "tools/reproduce/svg_canvas.h"

namespace sinkmesh::reproduce {
namespace {

constexpr double kPlaneRatio = 1.0;
constexpr double kSpaceRatio = 2.0;
constexpr int kPictureWidth = 900;

// Of each model. The literal rounds of the schedule whose evolution is charted; all others pruned. Off-sinks,
// which the paper does not have, come last.
std::vector<Plan> plans(int dimension) {
  std::vector<Plan> result;
  for (const Insert insert : {Insert::sink, Insert::circumcenter}) {
    result.push_back({insert, Schedule::block, false});
    if (dimension == 2) result.push_back({insert, Schedule::block, true});
    result.push_back({insert, Schedule::incremental, false});
    result.push_back({insert, Schedule::parallel, false});
    result.push_back({insert, Schedule::parallel, true});
  }
  for (const Schedule schedule : {Schedule::incremental, Schedule::block}) {
    result.push_back({Insert::off_sink, schedule, false});
  }
  return result;
}

// Work that does not depend on other work, the longest first, on all cores. The first exception is thrown on.
class TaskQueue {
 public:
  void add(int weight, std::string name, std::function<void()> run) {
    tasks_.push_back({weight, std::move(name), std::move(run)});
  }

  void run_all(const std::function<void(std::string_view)>& tell) {
    std::stable_sort(tasks_.begin(), tasks_.end(),
                     [](const Task& a, const Task& b) { return a.weight > b.weight; });
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr error;
    const auto work = [&] {
      for (std::size_t i = next++; i < tasks_.size(); i = next++) {
        try {
          {
            const std::lock_guard lock(mutex);
            if (error) return;
            tell(fmt::format("{} of {}: {}", i + 1, tasks_.size(), tasks_[i].name));
          }
          tasks_[i].run();
        } catch (...) {
          const std::lock_guard lock(mutex);
          if (!error) error = std::current_exception();
        }
      }
    };
    {
      std::vector<std::jthread> threads;
      for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) threads.emplace_back(work);
      work();
    }
    if (error) std::rethrow_exception(error);
  }

 private:
  struct Task {
    int weight;
    std::string name;
    std::function<void()> run;
  };
  std::vector<Task> tasks_;
};

template <int Dim>
void add_study(TaskQueue& queue, const std::string& model, const Surface<Dim>& surface, double max_ratio,
               Study& study) {
  study = begin_study<Dim>(model, surface, max_ratio);
  const std::vector<Plan> all = plans(Dim);
  study.runs.resize(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Plan plan = all[k];
    const int weight = (plan.literal ? 4 : 0) + (plan.schedule == Schedule::parallel ? 2 : 0) +
                       (plan.insert == Insert::circumcenter ? 1 : 0) + (Dim == 3 ? 8 : 0);
    queue.add(
        weight, fmt::format("{}, {}, {}", model, name(plan.insert), schedule_text(plan)),
        [&surface, max_ratio, plan, run = &study.runs[k]] { *run = refine_as<Dim>(surface, max_ratio, plan); });
  }
}

Picture image(const Image& picture, const std::string& name, const std::string& description,
              const std::string& caption) {
  std::string bytes = encode_png(picture);
  return {fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">", data_uri("image/png", bytes),
                      picture.width, picture.height, escape(description)),
          caption, name + ".png", std::move(bytes)};
}

Picture drawing(const std::string& svg, const std::string& name, const std::string& caption) {
  return {svg, caption, name + ".svg", svg};
}

// The surface, and cuts through the mesh inside, before and after.
std::vector<Picture> pictures_in_space(const std::string& model, const Surface3& surface) {
  const int height = picture_height(model, kPictureWidth);
  SurfaceMesher3 mesher(surface);
  mesher.find_domain();
  const RatioScale scale{kSpaceRatio, std::max(2 * kSpaceRatio, mesher.statistics(kSpaceRatio).max_ratio())};
  const auto cut = [&](const char* name, const char* when) {
    return image(cut_view(mesher.mesh(), cut_of(model), cut_view_of(model), scale, kPictureWidth, height),
                 model + name, fmt::format("Cut through the mesh of the {}, {}", model, when),
                 fmt::format("A cut through the interior, {}; colour: r/ℓ.{}", when, colour_bar_svg(scale)));
  };
  std::vector<Picture> pictures = {image(surface_view(surface, view_of(model), kPictureWidth, height),
                                         model + "-surface", fmt::format("The surface of the {}", model),
                                         "The input surface.")};
  pictures.push_back(cut("-before", "before"));
  const auto refine = [&](Insert insert, Schedule schedule) {
    mesher = SurfaceMesher3(surface);
    mesher.find_domain();
    RefineOptions options;
    options.max_ratio = kSpaceRatio;
    options.insert = insert;
    options.schedule = schedule;
    mesher.refine(options);
  };
  refine(Insert::sink, Schedule::parallel);
  pictures.push_back(cut("-after", "after inserting sinks in parallel"));
  refine(Insert::circumcenter, Schedule::incremental);
  pictures.push_back(cut("-circumcenters", "after inserting circumcenters one by one"));
  refine(Insert::off_sink, Schedule::incremental);
  pictures.push_back(cut("-off-sinks", "after inserting off-sinks one by one"));
  return pictures;
}

std::vector<Picture> plane_figures(const Surface2& usa) {
  return {
      drawing(
          figure_level_sets(), "figure-1",
          "Figure 1. Left: level sets of π over the Voronoi diagram. Right: level sets of φ over the Delaunay "
          "triangulation. Lighter is higher."),
      drawing(figure_watersheds(usa), "figure-2",
              "Figure 2. Triangles that contain their own circumcenters, the sinks, and the bold boundaries of "
              "their ancestor sets."),
      drawing(figure_graph_of_phi(usa), "figure-3",
              "Figure 3. The graph of φ, one paraboloid patch for each triangle; low values on top."),
      drawing(figure_flow_relation(), "figure-4",
              "Figure 4. The flow relation between two triangles, and in a whole triangulation."),
      drawing(figure_flowers(), "figure-5",
              "Figure 5. The prestar of a point and its star, and the flowers of both."),
      drawing(figure_first_sinks(usa), "figure-6",
              "Figure 6. The USA before, and after 4, 12 and 15 sinks, r/ℓ ≤ 1."),
  };
}

std::vector<File> all_files(PageContent& content) {
  std::vector<Study> studies;
  for (const StudyPage& s : content.studies) studies.push_back(s.study);
  std::vector<File> files = {{"results.json", results_json(studies, content.machine)},
                             {"runs.csv", runs_csv(studies)},
                             {"rounds.csv", rounds_csv(studies)}};
  const auto add = [&](std::vector<Picture>& pictures) {
    for (Picture& picture : pictures) files.push_back({picture.file_name, std::move(picture.file)});
  };
  add(content.figures);
  for (StudyPage& s : content.studies) add(s.pictures);
  files.push_back({"index.html", page(content)});  // last: when it is there, all is there
  return files;
}

}  // namespace

std::vector<File> reproduce(const Models& models, const std::string& machine,
                            const std::function<void(std::string_view)>& tell) {
  const auto start = std::chrono::steady_clock::now();
  PageContent content;
  content.machine = machine;
  content.studies.resize(1 + models.in_space.size());
  TaskQueue queue;
  add_study(queue, "usa", models.usa, kPlaneRatio, content.studies[0].study);
  queue.add(0, "figures of the plane", [&] {
    content.figures = plane_figures(models.usa);
    content.studies[0].pictures = {drawing(
        figure_block_meshes(models.usa), "figure-7",
        "The USA after inserting sinks, and circumcenters, in blocks, r/ℓ ≤ 1. Boundary edges are kept.")};
  });
  for (std::size_t k = 0; k < models.in_space.size(); ++k) {
    const std::string& name = models.in_space[k].first;
    const Surface3& surface = models.in_space[k].second;
    StudyPage& study = content.studies[k + 1];
    add_study(queue, name, surface, kSpaceRatio, study.study);
    queue.add(1, name + ", pictures", [&] { study.pictures = pictures_in_space(name, surface); });
  }
  queue.run_all(tell);

  content.total_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return all_files(content);
}

}  // namespace sinkmesh::reproduce
