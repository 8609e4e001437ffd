#include "seeding/lineSweep.H"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gpuFsi
{

namespace
{

struct event
{
    const lineCrossing* crossing;
    int region;
};

class sweeper
{
public:

    sweeper(const lattice& l, const std::vector<regionTrace>& traces)
    :
        lattice_(l),
        traces_(traces),
        tolerance_(1e-3*l.h()),
        fluid_(traces.size()),
        face_(std::pow(l.h(), l.dimensions() - 1))
    {
        for (std::size_t r = 0; r < traces.size(); ++r)
        {
            for (const lineCrossing& c : traces[r].crossings)
            {
                events_.push_back({&c, int(r)});
                noteOnWall(c);
            }
        }
        std::sort
        (
            events_.begin(),
            events_.end(),
            [](const event& a, const event& b)
            {
                const lineCrossing& p = *a.crossing;
                const lineCrossing& q = *b.crossing;
                return std::tie(p.axis, p.line, p.t, a.region, p.enters)
                    < std::tie(q.axis, q.line, q.t, b.region, q.enters);
            }
        );
    }

    sweptLines run()
    {
        auto first = events_.begin();
        for (int axis = 0; axis < lattice_.dimensions(); ++axis)
        {
            double length = 0;
            for (std::size_t line = 0; line < lattice_.nLines(axis); ++line)
            {
                auto last = first;
                while
                (
                    last != events_.end()
                 && last->crossing->axis == axis
                 && last->crossing->line == line
                )
                {
                    ++last;
                }
                length += sweep(axis, line, first, last);
                first = last;
            }
            result_.volume += length*face_/lattice_.dimensions();
        }
        return std::move(result_);
    }

private:

    using iterator = std::vector<event>::const_iterator;

    //- Lattice points that lie in a wall across the axis of a crossing
    void noteOnWall(const lineCrossing& c)
    {
        const double cells = (c.t - component(lattice_.lo(), c.axis))
            /lattice_.h() - 0.5;
        const double i = std::round(cells);
        const bool on = std::abs(cells - i)*lattice_.h() < tolerance_
         && i >= 0 && i < lattice_.n(c.axis)
         && std::abs(component(c.normal, c.axis)) > 1 - 1e-6;
        if (on)
        {
            onWall_.resize(lattice_.size());
            onWall_
            [
                lattice_.firstPoint(c.axis, c.line)
              + std::size_t(i)*lattice_.stride(c.axis)
            ] |= 1 << c.axis;
        }
    }

    //- What of a chord is not fluid: a line that lies in a wall has only half
    //  of its width in the fluid, in the edge of two walls a quarter
    double inWalls(int axis, std::size_t line, double from, double to) const
    {
        if (onWall_.empty() || !(to > from))
        {
            return 0;
        }
        const std::size_t point = lattice_.firstPoint(axis, line);
        const double h = lattice_.h();
        double length = 0;
        for (long i = 0; i < lattice_.n(axis); ++i)
        {
            const int walls = onWall_[point + i*lattice_.stride(axis)];
            double share = 1;
            for (int other = 0; other < lattice_.dimensions(); ++other)
            {
                share *= other != axis && (walls >> other & 1) ? 0.5 : 1;
            }
            if (share < 1)
            {
                const double low = lattice_.centre(axis, i) - h/2;
                const double part = std::min(to, low + h) - std::max(from, low);
                length += (1 - share)*std::max(part, 0.0);
            }
        }
        return length;
    }

    //- Returns the length of fluid on the line
    double sweep(int axis, std::size_t line, iterator first, iterator last)
    {
        const std::size_t point = lattice_.firstPoint(axis, line);
        const double low = component(lattice_.lo(), axis);
        const double high = component(lattice_.hi(), axis);

        std::size_t nOutside = 0;
        for (std::size_t r = 0; r < traces_.size(); ++r)
        {
            fluid_[r] = traces_[r].inside[point];
        }
        for (auto e = last; e != first; )
        {
            --e;
            fluid_[e->region] = !e->crossing->enters;
        }
        for (const char f : fluid_)
        {
            nOutside += !f;
        }

        double length = 0;
        double from = low;
        bool openLow = true;
        bool openHigh = true;
        for (auto e = first; e != last; ++e)
        {
            const double t = std::clamp(e->crossing->t, low, high);
            length += nOutside == 0
                ? t - from - inWalls(axis, line, from, t) : 0;
            from = t;
            nOutside -= !fluid_[e->region];
            fluid_[e->region] = e->crossing->enters;
            nOutside += !fluid_[e->region];
            const double end = e->crossing->t;
            openLow = openLow
             && (end < low - tolerance_ || end > lattice_.centre(axis, 0));
            openHigh = openHigh
             && (end > high + tolerance_
              || end < lattice_.centre(axis, lattice_.n(axis) - 1));
            addCandidate(axis, line, e, first, last);
        }
        length += nOutside == 0
            ? high - from - inWalls(axis, line, from, high) : 0;
        noteOpenEnds(axis, point, openLow, openHigh);
        return length;
    }

    void noteOpenEnds(int axis, std::size_t point, bool low, bool high)
    {
        if (lattice_.periodic(axis))
        {
            return;
        }
        const std::size_t end =
            point + (lattice_.n(axis) - 1)*lattice_.stride(axis);
        result_.openEnds[2*axis] += low && allInside(point);
        result_.openEnds[2*axis + 1] += high && allInside(end);
    }

    bool allInside(std::size_t point) const
    {
        for (const regionTrace& t : traces_)
        {
            if (!t.inside[point])
            {
                return false;
            }
        }
        return true;
    }

    void addCandidate
    (
        int axis,
        std::size_t line,
        iterator at,
        iterator first,
        iterator last
    )
    {
        const lineCrossing& c = *at->crossing;
        const double low = component(lattice_.lo(), axis);
        const double high = component(lattice_.hi(), axis);
        const bool onSeam =
            lattice_.periodic(axis)
         && (c.t < low + tolerance_ || c.t > high - tolerance_);
        if (c.t < low - tolerance_ || c.t > high + tolerance_ || onSeam)
        {
            return;
        }
        for (std::size_t r = 0; r < traces_.size(); ++r)
        {
            if (int(r) != at->region && !insideOrOn(r, c, first, last))
            {
                return;
            }
        }
        const std::size_t point = lattice_.firstPoint(axis, line);
        vector p = lattice_.point(point);
        component(p, axis) = c.t;
        const double alignment = std::abs(component(c.normal, axis));
        result_.candidates.push_back
        ({
            {p, c.normal, face_*alignment, at->region}, alignment, false
        });
    }

    //- Is region r fluid at the crossing, or does its surface pass through it?
    bool insideOrOn
    (
        std::size_t r,
        const lineCrossing& c,
        iterator first,
        iterator last
    ) const
    {
        const lineCrossing* before = nullptr;
        const lineCrossing* after = nullptr;
        for (auto e = first; e != last; ++e)
        {
            if (std::size_t(e->region) != r)
            {
                continue;
            }
            if (std::abs(e->crossing->t - c.t) <= tolerance_)
            {
                return true;
            }
            if (e->crossing->t < c.t)
            {
                before = e->crossing;
            }
            else if (!after)
            {
                after = e->crossing;
            }
        }
        return before ? before->enters
            : after ? !after->enters
            : traces_[r].inside[lattice_.firstPoint(c.axis, c.line)];
    }

    const lattice& lattice_;
    const std::vector<regionTrace>& traces_;
    double tolerance_;    // surfaces in single precision meet within it
    std::vector<char> fluid_;
    double face_;
    std::vector<event> events_;
    std::vector<std::uint8_t> onWall_;    // by point, a bit an axis
    sweptLines result_;
};

} // namespace

sweptLines sweepLines
(
    const lattice& l,
    const std::vector<regionTrace>& traces
)
{
    return sweeper(l, traces).run();
}

} // namespace gpuFsi
