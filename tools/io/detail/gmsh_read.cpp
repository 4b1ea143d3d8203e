// SPDX-License-Identifier: MIT
//
// Gmsh's .msh in text, versions 4.1 and 2.2. Nodes and elements have tags, in any order and with gaps.
#include <algorithm>
#include <numeric>

#include "tools/io/detail/codecs.h"
#include "tools/io/detail/concat.h"
#include "tools/io/detail/references.h"
#include "tools/io/detail/shapes.h"
#include "tools/io/detail/text_reader.h"

namespace sinkmesh::io_detail {
namespace {

constexpr std::int64_t kLine = 1;
constexpr std::int64_t kPoint = 15;
constexpr std::int64_t kMaxTags = 1000;

// Tags and what they stand for, found by binary search unless they count 1, 2, 3, ...
class TagMap {
 public:
  void add(std::int64_t tag, std::int64_t value) {
    is_plain_ = is_plain_ && tag == static_cast<std::int64_t>(entries_.size()) + 1;
    entries_.emplace_back(tag, value);
  }
  std::size_t size() const { return entries_.size(); }
  /// Must come between the last add() and the first find(). Returns false if a tag occurs twice.
  bool finish() {
    if (is_plain_) return true;
    std::sort(entries_.begin(), entries_.end());
    return std::adjacent_find(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) {
             return a.first == b.first;
           }) == entries_.end();
  }
  /// Null if there is no such tag.
  const std::int64_t* find(std::int64_t tag) const {
    if (is_plain_) {
      return tag >= 1 && static_cast<std::uint64_t>(tag) <= entries_.size()
                 ? &entries_[static_cast<std::size_t>(tag - 1)].second
                 : nullptr;
    }
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), tag,
                                        [](const auto& entry, std::int64_t t) { return entry.first < t; });
    return found != entries_.end() && found->first == tag ? &found->second : nullptr;
  }

 private:
  std::vector<std::pair<std::int64_t, std::int64_t>> entries_;
  bool is_plain_ = true;
};

// Cells as they come, and put into the order of their tags at the end.
template <class Cell>
struct TaggedCells {
  std::vector<Cell> cells;
  std::vector<std::int64_t> tags;
  std::vector<std::int64_t> physical;

  void sort() {
    if (std::is_sorted(tags.begin(), tags.end())) return;
    std::vector<std::size_t> order(tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
    const TaggedCells old = *this;
    for (std::size_t i = 0; i < order.size(); ++i) {
      cells[i] = old.cells[order[i]];
      physical[i] = old.physical[order[i]];
    }
  }
};

template <int Dim>
class GmshReader {
 public:
  explicit GmshReader(const Source& source) : text_(source.bytes, source.file, TextReader::kNoComment) {}

  Mesh<Dim> read() {
    if (text_.at_end() || text_.peek() != "$MeshFormat") {
      text_.fail("not a Gmsh file: it does not start with $MeshFormat; name the right --format");
    }
    while (!text_.at_end()) section(text_.word("a section"));
    if (!has_nodes_) text_.fail_at_end("the section $Nodes");
    if (!has_elements_) text_.fail_at_end("the section $Elements");
    simplices_.sort();
    facets_.sort();
    mesh_.simplices = std::move(simplices_.cells);
    mesh_.boundary = std::move(facets_.cells);
    add_references(mesh_.simplex_fields, "physical", std::move(simplices_.physical));
    add_references(mesh_.boundary_fields, "physical", std::move(facets_.physical));
    return std::move(mesh_);
  }

 private:
  void section(std::string_view name) {
    if (!name.starts_with('$')) {
      text_.fail(concat("'", printable(name),
                        "' stands where a section ($Nodes, ...) was expected: correct the file"));
    }
    const std::string end = concat("$End", name.substr(1));
    if (name == "$MeshFormat") {
      format();
    } else if (name == "$Nodes") {
      nodes();
    } else if (name == "$Elements") {
      elements();
    } else if (name == "$Entities" && version_ == 4) {
      entities();
    } else {
      skip_section(end);
      return;
    }
    const std::string_view found = text_.word(printable(end).c_str());
    if (found != end) {
      text_.fail(concat("'", printable(found), "' stands where ", end,
                        " was expected: correct the counts of the section"));
    }
  }

  void skip_section(const std::string& end) {
    text_.drop_line();
    while (!text_.at_end()) {
      if (text_.rest_of_line().starts_with(end)) return;
    }
    text_.fail_at_end(printable(end).c_str());
  }

  void format() {
    const std::string_view version = text_.word("the version");
    if (version != "4.1" && version != "2.2") {
      text_.fail(
          concat("version ", printable(version), " of the format cannot be read: save it as 4.1 or 2.2"));
    }
    version_ = version == "4.1" ? 4 : 2;
    if (text_.integer("the kind of file") != 0) text_.fail("binary .msh cannot be read: save it as text");
    text_.integer("the size of a double");
  }

  void need_version() const {
    if (version_ == 0) text_.fail("the section $MeshFormat must come first");
  }

  void skip_integers(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) text_.integer("a tag");
  }
  void skip_numbers(int count) {
    for (int i = 0; i < count; ++i) text_.number("a coordinate");
  }

  // Points have one position, the others a box and a list of what bounds them.
  void entities() {
    std::size_t counts[4];
    for (std::size_t& n : counts) n = text_.count("the number of entities", 2);
    for (int dim = 0; dim < 4; ++dim) {
      for (std::size_t i = 0; i < counts[dim]; ++i) {
        const std::int64_t tag = text_.integer("a tag");
        skip_numbers(dim == 0 ? 3 : 6);
        const std::size_t groups = text_.count("the number of physical groups", 2);
        const std::int64_t physical = groups == 0 ? 0 : text_.integer("a physical tag");
        skip_integers(groups == 0 ? 0 : groups - 1);
        if (dim != 0) skip_integers(text_.count("the number of bounding entities", 2));
        if (dim == Dim) simplex_physical_.add(tag, physical);
        if (dim == Dim - 1) facet_physical_.add(tag, physical);
      }
    }
    if (!simplex_physical_.finish() || !facet_physical_.finish())
      text_.fail("two entities have the same tag: correct the section $Entities");
  }

  void nodes() {
    need_version();
    if (has_nodes_) text_.fail("a second section $Nodes: join the two");
    has_nodes_ = true;
    if (version_ == 2) {
      const std::size_t rows = text_.count("the number of nodes", 8);
      for (std::size_t i = 0; i < rows; ++i) {
        add_node_tag(text_.integer("a node tag"));
        node();
      }
    } else {
      const std::size_t blocks = text_.count("the number of blocks", 2);
      const std::size_t total = text_.count("the number of nodes", 8);
      skip_integers(2);
      for (std::size_t b = 0; b < blocks; ++b) {
        skip_integers(3);
        const std::size_t rows = text_.count("the number of nodes in a block", 8);
        for (std::size_t i = 0; i < rows; ++i) add_node_tag(text_.integer("a node tag"));
        for (std::size_t i = 0; i < rows; ++i) node();
      }
      check_total("nodes", mesh_.points.size(), total);
    }
    if (!index_of_node_.finish()) text_.fail("two nodes have the same tag: number them differently");
  }
  void add_node_tag(std::int64_t tag) {
    index_of_node_.add(tag, static_cast<std::int64_t>(index_of_node_.size()));
  }
  void node() {
    Point<Dim>& p = mesh_.points.emplace_back();
    for (double& x : p) x = text_.number("a coordinate");
    if (Dim == 2 && text_.number("a coordinate") != 0) {
      text_.fail("this node is not in the plane z = 0: a plane mesh is needed here");
    }
    text_.drop_line();  // parameters on a curve or surface
  }

  void elements() {
    need_version();
    has_elements_ = true;
    if (!has_nodes_) text_.fail("the section $Elements comes before $Nodes: put the nodes first");
    if (version_ == 2) {
      const std::size_t rows = text_.count("the number of elements", 6);
      for (std::size_t i = 0; i < rows; ++i) {
        const std::int64_t tag = text_.integer("an element tag");
        const std::int64_t type = text_.integer("an element type");
        const std::int64_t tags = text_.integer("the number of tags");
        if (tags < 0 || tags > kMaxTags) text_.fail(concat("an element has ", tags, " tags: correct it"));
        const std::int64_t physical = tags == 0 ? 0 : text_.integer("a tag");
        skip_integers(tags == 0 ? 0 : static_cast<std::size_t>(tags - 1));
        element(tag, type, physical);
      }
      return;
    }
    const std::size_t blocks = text_.count("the number of blocks", 2);
    const std::size_t total = text_.count("the number of elements", 4);
    skip_integers(2);
    std::size_t seen = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int64_t dim = text_.integer("a dimension");
      const std::int64_t entity = text_.integer("an entity tag");
      const std::int64_t type = text_.integer("an element type");
      const std::size_t rows = text_.count("the number of elements in a block", 4);
      const std::int64_t* const physical = dim == Dim       ? simplex_physical_.find(entity)
                                           : dim == Dim - 1 ? facet_physical_.find(entity)
                                                            : nullptr;
      for (std::size_t i = 0; i < rows; ++i) {
        element(text_.integer("an element tag"), type, physical != nullptr ? *physical : 0);
      }
      seen += rows;
    }
    check_total("elements", seen, total);
  }

  void check_total(const char* things, std::size_t seen, std::size_t announced) const {
    if (seen == announced) return;
    text_.fail(concat("the blocks hold ", seen, " ", things, ", but ", announced,
                      " are announced: correct the counts"));
  }

  void element(std::int64_t tag, std::int64_t type, std::int64_t physical) {
    if (type == Shapes<Dim>::kGmshSimplex) {
      add(simplices_, tag, physical);
    } else if (type == Shapes<Dim>::kGmshFacet) {
      add(facets_, tag, physical);
    } else if (type == kLine || type == kPoint) {
      text_.drop_line();
    } else {
      text_.fail(concat("element ", tag, " has Gmsh type ", type, ": only type ", Shapes<Dim>::kGmshSimplex,
                        " (", Shapes<Dim>::kSimplex, ") can be read; convert the mesh"));
    }
  }
  template <class Cell>
  void add(TaggedCells<Cell>& out, std::int64_t tag, std::int64_t physical) {
    Cell& cell = out.cells.emplace_back();
    for (std::uint32_t& v : cell) {
      const std::int64_t node = text_.integer("a node tag");
      const std::int64_t* const index = index_of_node_.find(node);
      if (index == nullptr) text_.fail(concat("node ", node, " does not exist: correct the tag"));
      v = static_cast<std::uint32_t>(*index);
    }
    out.tags.push_back(tag);
    out.physical.push_back(physical);
  }

  TextReader text_;
  Mesh<Dim> mesh_;
  TagMap index_of_node_;
  TagMap simplex_physical_;  // of entities
  TagMap facet_physical_;
  TaggedCells<typename Mesh<Dim>::Simplex> simplices_;
  TaggedCells<typename Mesh<Dim>::Facet> facets_;
  int version_ = 0;
  bool has_nodes_ = false;
  bool has_elements_ = false;
};

}  // namespace

template <int Dim>
Mesh<Dim> decode_msh(const Source& source) {
  return GmshReader<Dim>(source).read();
}

template Mesh2 decode_msh<2>(const Source&);
template Mesh3 decode_msh<3>(const Source&);

}  // namespace sinkmesh::io_detail
