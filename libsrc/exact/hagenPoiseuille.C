//- Fluid in a round pipe, driven along it by a body force from t = 0: the
//  Bessel series of the start-up (incompressible), Hagen-Poiseuille at last.
//  Keys: radius (m), origin ((0 0 0)) on the axis, axis ((1 0 0)), g (m/s^2;
//  only its part along the axis drives), rho0, nu.

#include "exact/velocitySolution.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::min();
constexpr double pi = 3.14159265358979323846;

//- Zero n (1, 2 ..) of J0: McMahon's expansion, then Newton
double zeroOfJ0(int n)
{
    const double b = (n - 0.25)*pi;
    double x = b + 1/(8*b) - 31/(384*b*b*b);
    for (int i = 0; i < 4; ++i)
    {
        x += std::cyl_bessel_j(0, x)/std::cyl_bessel_j(1, x);
    }
    return x;
}

class hagenPoiseuille
:
    public velocitySolution
{
public:

    hagenPoiseuille(const dictionary& dict, const fluidConstants& fluid)
    :
        radius_(dict.getNumber("radius", tiny, huge)),
        nu_(dict.getNumberOrDefault("nu", fluid.nu, tiny, huge)),
        origin_(dict.getOrDefault<vector>("origin", {0, 0, 0})),
        axis_(dict.getOrDefault<vector>("axis", {1, 0, 0}))
    {
        const double length = std::sqrt(dot(axis_, axis_));
        if (!(length > 0))
        {
            throw userError
            (
                "axis has no length", dict.where("axis"), "Give (1 0 0)."
            );
        }
        axis_ = (1/length)*axis_;
        drive_ = dot(axis_, fluid.steadyForce(dict));
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double scale = radius_*radius_/nu_;
        std::vector<mode> modes;
        for (int n = 1; n < 2000 && t > 0; ++n)
        {
            const double k = zeroOfJ0(n);
            const double decay = k*k*t/scale;
            if (decay > 40)
            {
                break;
            }
            modes.push_back
            ({
                k, 2*std::exp(-decay)/(k*k*k*std::cyl_bessel_j(1, k))
            });
        }
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const vector d = p - origin_;
            const vector across = d - dot(d, axis_)*axis_;
            const double r = std::sqrt(dot(across, across))/radius_;
            double u = t > 0 ? 0.25*(1 - r*r) : 0;
            for (const mode& m : modes)
            {
                u -= m.amplitude*std::cyl_bessel_j(0, m.k*r);
            }
            values.push_back(scale*drive_*u*axis_);
        }
        return values;
    }

private:

    struct mode
    {
        double k;            // 1/radius
        double amplitude;
    };

    double radius_, nu_;
    vector origin_, axis_;
    double drive_ = 0;
};

const exactSolution::selection::add<hagenPoiseuille> add("hagenPoiseuille");

} // namespace

} // namespace gpuFsi
