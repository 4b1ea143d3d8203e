# SPDX-License-Identifier: MIT
#
# The target `coverage`: the tests of predicates, core and refine, then a table of lines for each; fails if one of the
# three has less than 95 % covered. It runs whole executables: a process for each test, which is ctest's way, would
# spend most of its time adding up counters.
find_program(SINKMESH_GCOVR gcovr REQUIRED)

set(runs "")
set(tables "")
foreach(layer IN ITEMS predicates core refine)
  list(APPEND runs COMMAND ${layer}_test --gtest_brief=1)
  list(APPEND tables COMMAND ${CMAKE_COMMAND} -E echo "Line coverage of ${layer}:"
    COMMAND ${SINKMESH_GCOVR} --root ${PROJECT_SOURCE_DIR} --filter ${PROJECT_SOURCE_DIR}/${layer}/
    --fail-under-line 95 ${PROJECT_BINARY_DIR})
endforeach()

add_custom_target(coverage
  COMMAND find . -name *.gcda -delete
  ${runs}
  ${tables}
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR} USES_TERMINAL VERBATIM)
