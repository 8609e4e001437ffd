#include "stepping/sceneTerms.H"

#include "common/fluids.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

domain fluidDomain()
{
    domain d;
    d.spacing = 1;
    d.volume = 1;
    return d;
}

} // namespace

TEST(sceneTerms, tellWhatIsUsedAndWhatIsNot)
{
    domain d = fluidDomain();
    particleSchemes schemes = defaultSchemes(d);
    EXPECT_EQ
    (
        sceneTerms(publishedFluid(), schemes, d, nullptr),
        "pressure, viscosity; left out: gravity, walls, wall motion, slip, "
        "area weights, gradients, dissipation, shifting, elastic solids"
    );
    d.walls = {"wall"};
    schemes.areaWeights = particleSchemes::weight::moment;
    schemes.shifting = 0.5;
    EXPECT_EQ
    (
        sceneTerms(publishedFluid(0), schemes, d, nullptr),
        "pressure, walls, area weights, gradients, shifting; left out: "
        "viscosity, gravity, wall motion, slip, dissipation, elastic solids"
    );
}


TEST(sceneTerms, tellOfSolidsWhereThereAreSome)
{
    domain d;    // no fluid
    solidScene solids;
    solids.properties.materials.resize(2);
    solids.properties.materials[1].viscous = 1;
    EXPECT_EQ
    (
        sceneTerms(publishedFluid(), defaultSchemes(d), d, &solids),
        "elastic solids, damping; left out: fluid, volume change, breaking "
        "bonds, contact"
    );
    solids.properties.materials[0].breakStrain = 0.1;
    solids.properties.materials[0].kappa = -1;
    solids.properties.contact.active = true;
    EXPECT_EQ
    (
        sceneTerms(publishedFluid(), defaultSchemes(d), d, &solids),
        "elastic solids, volume change, damping, breaking bonds, contact; "
        "left out: fluid"
    );
}


TEST(sceneTerms, tellWhatMemoryIsFor)
{
    EXPECT_EQ
    (
        describe({{"state", 680}, {"walls", 0}, {"neighbours", 1045}}, 10),
        "state 68.0, neighbours 104.5"
    );
    EXPECT_EQ(describe({{"walls", 0}}, 1), "");
}

