//- A shear wave in a periodic box, decaying; exact for the compressible
//  equations, too, as neither density nor pressure changes:
//      U = speed exp(-nu k^2 t) (0, sin kx, 0)
//  with k = 2 pi/length and x measured from origin. U only.
//  Keys: length (m, 1), speed (m/s, 1), origin, nu.

#include "exact/periodicFlow.H"
#include "exact/velocitySolution.H"

#include <cmath>

namespace gpuFsi
{

namespace
{

class shearWave
:
    public velocitySolution
{
public:

    shearWave(const dictionary& dict, const fluidConstants& fluid)
    :
        flow_(dict, fluid),
        speed_(dict.getOrDefault<double>("speed", 1))
    {}

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double now = speed_*std::exp(-flow_.rate()*t);
        std::vector<vector> values;
        for (const vector& p : points)
        {
            values.push_back({0, now*std::sin(flow_.phase(p).x), 0});
        }
        return values;
    }

private:

    periodicFlow flow_;
    double speed_;
};

const exactSolution::selection::add<shearWave> add("shearWave");

} // namespace

} // namespace gpuFsi
