#include "runControls.H"

namespace gpuFsi
{

runControls::runControls(const dictionary& d)
:
    backend(d.getChoiceOrDefault("backend", "auto", {"auto", "cpu", "cuda"})),
    precision
    (
        d.getChoiceOrDefault("precision", "double", {"single", "double"})
    ),
    logInterval(long(d.getNumberOrDefault("logInterval", 10, 1, 1e9))),
    maxDi(d.getNumberOrDefault("maxDi", 0.4, 1e-6, 0.5)),
    allowUnstable(d.getOrDefault("allowUnstable", false))
{}

} // namespace gpuFsi
