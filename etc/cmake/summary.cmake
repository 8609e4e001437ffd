message(STATUS "gpuFsiFoam ${PROJECT_VERSION}:")
macro(fsi_say have part without)
    if(${have})
        message(STATUS "  ${part}: yes")
    else()
        message(STATUS "  ${part}: no; left out: ${without}")
    endif()
endmacro()
fsi_say(HAVE_CUDA "CUDA" "the cuda backend (the cpu backend is complete)")
fsi_say(HAVE_CGAL "CGAL"
    "surface meshes (seedParticles still seeds level sets and points)")
fsi_say(HAVE_VTK "VTK" "particlesToVTK (ParaView reads the case directly)")
fsi_say(HAVE_SCOTCH "Scotch"
    "method scotch of decomposeParticles (hilbert is there)")
