// Which walls the solids of a scene may touch.

#include "barColumn.H"
#include "coupling/touchedWalls.H"

#include <gtest/gtest.h>

using namespace gpuFsi;


TEST(touchedWalls, allButTheSolidsOwn)
{
    barColumn scene;
    scene.fluid.motions.resize(2);
    scene.fluid.motions[0] = wallMotion::make
    (
        dictionary::fromString("type translation; velocity (1 0 0);")
    );
    scene.state.time = 3;
    const contactWalls walls = touchedWalls(scene.state, scene.fluid);
    ASSERT_EQ(int(walls.points.size()), barColumn::across);
    for (std::size_t w = 0; w < walls.points.size(); ++w)
    {
        EXPECT_EQ(walls.points[w].x, 0);
        EXPECT_EQ(walls.normals[w].x, 1);
        EXPECT_EQ(walls.patch[w], 0);
        EXPECT_EQ(walls.area[w], scene.space.spacing);
    }
    EXPECT_EQ(walls.fluidSpacing, scene.space.spacing);
    EXPECT_EQ(walls.time, 3);
    EXPECT_TRUE(walls.move());
    EXPECT_EQ(walls.at(3)[0].position({0, 0, 0}).x, 3);
}
