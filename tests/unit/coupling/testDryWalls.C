// Wall particles whose neighbours are all walls.

#include "fluid/dryWallStep.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

//- Walls 0 to 4 in a row, fluid particle 5 seen by 0 alone. 1 sees 0 and 2, 2
//  sees 1, 3 sees 0 but lies on the other side, 4 sees 0 but is another wall.
struct row
{
    static constexpr int nWalls = 5, n = 6;
    int list[8*n];
    placeRho<double> place[n]{};
    velocity4<double> velocity[n]{};
    int wet[nWalls], someDry = 0;
    int id[nWalls]{0, 1, 2, 3, 4};
    int patch[nWalls]{0, 0, 0, 0, 1};
    vector normal[nWalls]
    {
        {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, -1, 0}, {0, 1, 0}
    };

    row()
    {
        for (int k = 0; k < 8; ++k)
        {
            for (int i = 0; i < n; ++i)
            {
                list[k*n + i] = i;          // empty
            }
        }
        for (int i = 0; i < nWalls; ++i)
        {
            place[i].x = i;
            place[i].deltaRho = 0.1*(i + 1);
        }
        list[0] = 5;
        list[1] = 0;
        list[n + 1] = 2;
        list[2] = 1;
        list[3] = 0;
        list[4] = 0;
    }

    void pass()
    {
        const wetWalls look{{n, list}, nWalls, 8, wet, &someDry};
        for (int i = 0; i < nWalls; ++i)
        {
            look(i);
        }
        wallStep<double, 2> step{};
        step.place = place;
        step.newPlace = place;
        step.newVelocity = velocity;
        step.neighbours = {n, list};
        step.nWalls = nWalls;
        step.quantum[0] = step.quantum[1] = step.quantum[2] = 1;
        step.rho0 = 1;
        step.perC2 = 0.01;
        step.g = {2, 0, 0};
        const dryWallStep<double, 2> dry{step, {wet, id, patch, normal}};
        for (int i = nWalls - 1; i >= 0; --i)
        {
            dry(i);
        }
    }
};

} // namespace


TEST(dryWalls, takeDensityFromWetOnesBesideThem)
{
    row r;
    r.pass();
    EXPECT_EQ(r.someDry, 1);
    EXPECT_EQ(r.wet[0], 1);
    EXPECT_EQ(r.wet[1], 0);

    // One spacing downhill: rho exp(g dx/c^2) to second order and beyond
    EXPECT_NEAR(1 + r.place[1].deltaRho, 1.1*std::exp(0.02), 1e-5);

    // Its neighbour 1 has no fluid itself; 3 and 4 may not borrow from 0
    EXPECT_EQ(r.place[0].deltaRho, 0.1);
    EXPECT_EQ(r.place[2].deltaRho, 0.1*3);
    EXPECT_EQ(r.place[3].deltaRho, 0.1*4);
    EXPECT_EQ(r.place[4].deltaRho, 0.1*5);
}
