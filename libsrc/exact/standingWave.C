//- Plane standing wave between two walls a length apart (free slip, or far
//  from the side walls), linear viscous acoustics:
//      deltaRho(s, 0) = amplitude cos(k s), k = mode pi/length, U(s, 0) = 0
//  Keys: amplitude (kg/m^3, 0.01), mode (1), and those of column.

#include "exact/column.H"
#include "exact/dampedMode.H"

#include <cmath>

namespace gpuFsi
{

namespace
{

class standingWave
:
    public exactSolution
{
public:

    standingWave(const dictionary& dict, const fluidConstants& fluid)
    :
        column_(dict, fluid),
        amplitude_(dict.getOrDefault<double>("amplitude", 0.01)),
        k_(std::acos(-1.0)*modeOf(dict)/column_.length),
        mode_(column_.c, column_.nu, k_)
    {}

    std::vector<double> scalar
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double now = amplitude_*mode_.release(t);
        std::vector<double> values;
        for (const vector& p : points)
        {
            values.push_back(now*std::cos(k_*column_.along(p)));
        }
        return values;
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double now =
            amplitude_*mode_.w2()*mode_.impulse(t)/(column_.rho0*k_);
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const double speed = now*std::sin(k_*column_.along(p));
            values.push_back(speed*column_.direction);
        }
        return values;
    }

private:

    static int modeOf(const dictionary& dict)
    {
        const int mode = dict.getOrDefault<int>("mode", 1);
        if (mode < 1)
        {
            throw userError
            (
                "mode " + std::to_string(mode) + " is not 1 or more",
                dict.where("mode"),
                "mode counts the half waves between the walls."
            );
        }
        return mode;
    }

    column column_;
    double amplitude_;
    double k_;
    dampedMode mode_;
};

const exactSolution::selection::add<standingWave> add("standingWave");

} // namespace

} // namespace gpuFsi
