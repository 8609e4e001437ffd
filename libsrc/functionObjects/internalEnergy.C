#include "functionObjects/internalEnergy.H"

#include "exact/gaussLegendre.H"

namespace gpuFsi
{

std::vector<double> internalEnergy
(
    const std::vector<double>& deltaRho,
    double rho0,
    const std::function<double(double)>& pressure
)
{
    const auto nodes = gaussLegendre(0, 1, 1);
    const double atRest = pressure(rho0);
    std::vector<double> energy(deltaRho.size());
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < deltaRho.size(); ++i)
    {
        double sum = 0;
        for (const auto& node : nodes)
        {
            const double rho = rho0 + node.x*deltaRho[i];
            sum += node.weight*(pressure(rho) - atRest)/(rho*rho);
        }
        energy[i] = sum*deltaRho[i];
    }
    return energy;
}

} // namespace gpuFsi
