//- What the particles are compared with: second-order finite differences and
//  the second-order semi-Lagrangian scheme on a grid in a periodic cube.
//
// Usage: gridReference [-case DIR]
// Reads  system/gridDict:
//            scheme  semiLagrangian;   // finiteDifferences[Euler]
//            n       64;               // points a side
//            length  15;               // of a side, m; centred at the origin
//            rho     "1 + 0.01*exp(-r^2/5)";    // at t = 0, at rest
//        system/controlDict, constant/fluidProperties as gpuFsiFoam does.
#include "base/log.H"
#include "case/argList.H"
#include "gridRun.H"

using namespace gpuFsi;

int main(int argc, char** argv)
{
    return runMain("gridReference", [&]
    {
        const argList args
        (
            argc, argv, "Solve a pulse on a grid, as system/gridDict says.",
            {}
        );
        printBanner(args.commandLine(), args.casePath().string());
        gridRun(args.casePath()).run();
        info("End\n");
        return 0;
    });
}
