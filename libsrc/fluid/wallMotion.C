#include "fluid/wallMotion.H"

#include <cmath>

namespace gpuFsi
{

namespace
{

class translation
:
    public wallMotion
{
public:

    explicit translation(const dictionary& d)
    :
        velocity_(d.getDimensionedVector("velocity", dimensions::velocity))
    {}

    rigidState at(double t) const override
    {
        rigidState s;
        s.shift = t*velocity_;
        s.velocity = velocity_;
        return s;
    }

private:

    vector velocity_;
};


class sliding
:
    public wallMotion
{
public:

    explicit sliding(const dictionary& d)
    :
        velocity_(d.getDimensionedVector("velocity", dimensions::velocity))
    {}

    rigidState at(double) const override
    {
        rigidState s;
        s.velocity = velocity_;
        return s;
    }

private:

    vector velocity_;
};


class oscillation
:
    public wallMotion
{
public:

    explicit oscillation(const dictionary& d)
    :
        amplitude_(d.getDimensionedVector("amplitude", dimensions::length)),
        omega_(d.get<double>("omega")),
        phase_(d.getOrDefault<double>("phase", 0))
    {}

    rigidState at(double t) const override
    {
        const double angle = omega_*t + phase_;
        rigidState s;
        s.shift = (std::sin(angle) - std::sin(phase_))*amplitude_;
        s.velocity = (omega_*std::cos(angle))*amplitude_;
        s.acceleration = (-omega_*omega_*std::sin(angle))*amplitude_;
        return s;
    }

private:

    vector amplitude_;
    double omega_;
    double phase_;
};


class rotation
:
    public wallMotion
{
public:

    explicit rotation(const dictionary& d)
    :
        origin_(d.getDimensionedVector("origin", dimensions::length)),
        axis_(d.get<vector>("axis")),
        omega_(d.get<double>("omega"))
    {
        const double length = std::sqrt(dot(axis_, axis_));
        if (!(length > 0))
        {
            throw userError
            (
                "The axis of a rotation must not be zero",
                d.where("axis")
            );
        }
        axis_ = (1/length)*axis_;
    }

    rigidState at(double t) const override
    {
        const double c = std::cos(omega_*t), s = std::sin(omega_*t);
        const vector a = axis_;
        rigidState state;
        state.rows[0] =
        {
            c + a.x*a.x*(1 - c),
            a.x*a.y*(1 - c) - a.z*s,
            a.x*a.z*(1 - c) + a.y*s
        };
        state.rows[1] =
        {
            a.y*a.x*(1 - c) + a.z*s,
            c + a.y*a.y*(1 - c),
            a.y*a.z*(1 - c) - a.x*s
        };
        state.rows[2] =
        {
            a.z*a.x*(1 - c) - a.y*s,
            a.z*a.y*(1 - c) + a.x*s,
            c + a.z*a.z*(1 - c)
        };
        state.centre = origin_;
        state.omega = omega_*axis_;
        return state;
    }

private:

    vector origin_;
    vector axis_;
    double omega_;
};


const wallMotion::table::add<translation> addTranslation("translation");
const wallMotion::table::add<sliding> addSliding("sliding");
const wallMotion::table::add<oscillation> addOscillation("oscillation");
const wallMotion::table::add<rotation> addRotation("rotation");

} // namespace


std::unique_ptr<wallMotion> wallMotion::make(const dictionary& wall)
{
    const std::string word = wall.get<std::string>("type");
    if (word == "fixed")
    {
        return nullptr;
    }
    return table::make("wall motion", word, wall.where("type"), wall);
}

} // namespace gpuFsi
