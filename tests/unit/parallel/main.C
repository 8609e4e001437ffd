// test_parallel [-parallel] [GoogleTest's options]

#include "theRanks.H"

#include <gtest/gtest.h>

#include <cstring>

namespace gpuFsi
{

const communicator* theRanks = nullptr;

}

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    const bool parallel = argc > 1 && std::strcmp(argv[1], "-parallel") == 0;
    const gpuFsi::communicator ranks(argc, argv, parallel);
    gpuFsi::theRanks = &ranks;
    const int failed = RUN_ALL_TESTS();
    // A rank that fails must not leave the others waiting for it
    if (failed)
    {
        ranks.abort();
    }
    return 0;
}
