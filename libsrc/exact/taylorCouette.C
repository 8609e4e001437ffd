//- Fluid between two coaxial cylinders that turn, at last:
//  u_theta = A r + B/r (incompressible, below the first instability).
//  Keys: innerRadius, outerRadius (m), innerOmega, outerOmega (rad/s, default
//  0, by the right-hand rule), origin ((0 0 0)), axis ((0 0 1)).

#include "exact/velocitySolution.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::min();

class taylorCouette
:
    public velocitySolution
{
public:

    taylorCouette(const dictionary& dict, const fluidConstants&)
    :
        origin_(dict.getOrDefault<vector>("origin", {0, 0, 0})),
        axis_(dict.getOrDefault<vector>("axis", {0, 0, 1}))
    {
        const double length = std::sqrt(dot(axis_, axis_));
        if (!(length > 0))
        {
            throw userError
            (
                "axis has no length", dict.where("axis"), "Give (0 0 1)."
            );
        }
        axis_ = (1/length)*axis_;

        const double inner = dict.getNumber("innerRadius", tiny, huge);
        const double outer = dict.getNumber("outerRadius", tiny, huge);
        if (!(outer > inner))
        {
            throw userError
            (
                "outerRadius is not greater than innerRadius",
                dict.where("outerRadius"),
                "The fluid is between the two cylinders."
            );
        }
        const double in = dict.getNumberOrDefault("innerOmega", 0, -huge, huge);
        const double out =
            dict.getNumberOrDefault("outerOmega", 0, -huge, huge);
        const double a = inner*inner;
        const double b = outer*outer;
        A_ = (out*b - in*a)/(b - a);
        B_ = (in - out)*a*b/(b - a);
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double
    ) const override
    {
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const vector d = p - origin_;
            const vector out = d - dot(d, axis_)*axis_;
            const double turning = A_ + B_/std::max(dot(out, out), tiny);
            values.push_back(turning*cross(axis_, out));
        }
        return values;
    }

private:

    vector origin_, axis_;
    double A_, B_;       // 1/s, m^2/s
};

const exactSolution::selection::add<taylorCouette> add("taylorCouette");

} // namespace

} // namespace gpuFsi
