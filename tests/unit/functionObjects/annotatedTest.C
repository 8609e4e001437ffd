#include "lattice.H"

using namespace gpuFsi;

TEST(annotated, isValidAndReadToTheLastKey)
{
    testRun run;
    const dictionary dict = dictionary::fromFile(FSI_ANNOTATED);
    functionObjectList list(dict, run.info);
    EXPECT_EQ(list.size(), dict.subDict("functions").keys().size());
    EXPECT_EQ(dict.unread(), std::vector<std::string>{});
}
