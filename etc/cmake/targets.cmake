# One static library a room: fsi_library(room SOURCES ... LINK ...)
function(fsi_flags target)
    set(cxxFlags -O3 -fno-math-errno -Wall -Wextra)
    if(FSI_NATIVE)
        list(APPEND cxxFlags -march=native)
    else()
        list(APPEND cxxFlags -march=x86-64-v3)
    endif()
    target_compile_options(${target} PRIVATE
        "$<$<COMPILE_LANGUAGE:CXX>:${cxxFlags}>")
    target_compile_options(${target} PRIVATE
        "$<$<COMPILE_LANGUAGE:CUDA>:--extended-lambda;-O3;-ftz=true;-Xcompiler=-O2>")
    target_include_directories(${target} PRIVATE
        ${PROJECT_SOURCE_DIR}/libsrc ${PROJECT_BINARY_DIR}/include)
endfunction()

function(fsi_library room)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    add_library(fsi_${room} STATIC ${arg_SOURCES})
    fsi_flags(fsi_${room})
    target_link_libraries(fsi_${room} PUBLIC ${arg_LINK})
endfunction()

function(fsi_application app)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    add_executable(${app} ${arg_SOURCES})
    fsi_flags(${app})
    target_link_libraries(${app} PRIVATE ${arg_LINK})
    install(TARGETS ${app} DESTINATION bin)
endfunction()

# Unit tests of one room, in tests/unit/<room>
function(fsi_unit_test room)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    add_executable(test_${room} ${arg_SOURCES})
    fsi_flags(test_${room})
    target_link_libraries(test_${room} PRIVATE ${arg_LINK} GTest::gtest_main)
    gtest_discover_tests(test_${room} DISCOVERY_MODE PRE_TEST
        TEST_PREFIX unit.${room}. PROPERTIES LABELS unit)
endfunction()
