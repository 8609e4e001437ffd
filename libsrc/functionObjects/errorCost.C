#include "functionObjects/errorCost.H"

#include <fmt/format.h>

namespace gpuFsi
{

std::string errorCost::header()
{
    return "# Time\tL1\tL2\tLinf\trelL1\trelL2\trelLinf\tloopSeconds"
        "\ttotalSeconds\tparticleSteps\tparticleStepsPerSecond\th\tdeltaT"
        "\tranks\tdevice\tprecision\tscheme\n";
}


std::string errorCost::row() const
{
    return fmt::format
    (
        "{:.12g}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}"
        "\t{:.8e}\t{:.17g}\t{:.8e}\t{:.12g}\t{:.12g}\t{}\t{}\t{}\t{}\n",
        run.time, error.L1, error.L2, error.Linf, relative.L1, relative.L2,
        relative.Linf, run.loopSeconds, run.totalSeconds, run.particleSteps,
        rate(), run.h, run.deltaT, run.ranks, run.device, run.precision,
        run.scheme
    );
}


std::string errorCost::sentence(const std::string& field) const
{
    return fmt::format
    (
        "error of {} at Time = {:.6g}: L1 = {:.4e} L2 = {:.4e} Linf = {:.4e} "
        "(relative {:.4e} {:.4e} {:.4e}) for loop = {:.4g} s total = {:.4g} s "
        "particle-steps = {:.6g} rate = {:.4g} MIPPS h = {:.6g} "
        "deltaT = {:.6g} ranks = {}, {}, {} precision, {}",
        field, run.time, error.L1, error.L2, error.Linf, relative.L1,
        relative.L2, relative.Linf, run.loopSeconds, run.totalSeconds,
        run.particleSteps, rate()/1e6, run.h, run.deltaT, run.ranks,
        run.device, run.precision, run.scheme
    );
}


double errorCost::rate() const
{
    return run.loopSeconds > 0 ? run.particleSteps/run.loopSeconds : 0;
}

} // namespace gpuFsi
