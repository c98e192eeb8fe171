# The parts of the core that the module for a first net does without: left_out.cpp and number.cpp have the same functions
# for it. A source is in one of the two modules or in the library of both, never twice.
file(GLOB LEFT_OUT_METHODS CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/core/solve/methods/*.cpp)
list(REMOVE_ITEM LEFT_OUT_METHODS ${CMAKE_CURRENT_SOURCE_DIR}/core/solve/methods/equilibrium.cpp)
set(LEFT_OUT_SHAPES ${CMAKE_CURRENT_SOURCE_DIR}/core/shapes/scroll.cpp ${CMAKE_CURRENT_SOURCE_DIR}/core/shapes/vase.cpp
    ${CMAKE_CURRENT_SOURCE_DIR}/core/shapes/wave.cpp)
# Of these it has the words, so that its tables are whole.
set(WORDS_SOURCES ${LEFT_OUT_METHODS} ${LEFT_OUT_SHAPES} ${CMAKE_CURRENT_SOURCE_DIR}/core/io/format.cpp)
file(GLOB LEFT_OUT_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/core/io/*.cpp
     ${CMAKE_CURRENT_SOURCE_DIR}/core/surface/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/core/drape/*.cpp
     ${CMAKE_CURRENT_SOURCE_DIR}/core/remesh/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/core/change/*.cpp)
list(APPEND LEFT_OUT_SOURCES ${LEFT_OUT_METHODS} ${LEFT_OUT_SHAPES})
foreach(source base/number net/cell_sides net/families net/rods net/triangulation shapes/smooth_figure shapes/relaxation edit/equalize edit/exact_change
               solve/parts/buckling solve/parts/turned_handles edit/by_hand edit/fair_start edit/flip edit/length_adapter edit/locality edit/net_forces edit/rest_search
               solve/parts/slides solve/parts/free_motions solve/parts/far_pulls solve/parts/pull_walk solve/terms/bent_lines solve/terms/closeness_term solve/terms/penalty_term
               fabricate/edge_table fabricate/flat_pattern fabricate/rod_table)
    list(APPEND LEFT_OUT_SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/core/${source}.cpp)
endforeach()
