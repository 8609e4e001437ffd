#include "decomposition/hilbertCurve.H"

#include <algorithm>
#include <cstdlib>

namespace gpuFsi
{

namespace
{

//- An edge of a box of blocks: along one axis, of signed length
struct edge
{
    int axis;
    int length;

    int size() const { return std::abs(length); }
    int sign() const { return length < 0 ? -1 : 1; }
    edge reversed() const { return {axis, -length}; }

    //- First half, of even length where the whole is longer than two
    edge half() const
    {
        const int whole = length/2;
        return {axis, whole % 2 && size() > 2 ? whole + sign() : whole};
    }
    edge minus(const edge& part) const { return {axis, length - part.length}; }
    edge step() const { return {axis, sign()}; }
};

struct place
{
    int at[3];

    place operator+(const edge& e) const
    {
        place p = *this;
        p.at[e.axis] += e.length;
        return p;
    }

    //- Last block of an edge that starts here
    place last(const edge& e) const
    {
        return *this + edge{e.axis, e.length - e.sign()};
    }
};

class walker
{
public:

    explicit walker(const int (&n)[3])
    :
        n_(n)
    {}

    //- Box from the corner p: enters there, leaves at the far end of a
    void walk(const place& p, const edge& a, const edge& b, const edge& c)
    {
        const int w = a.size(), h = b.size(), d = c.size();
        if (w == 0 || h == 0 || d == 0)
        {
            return;
        }
        if ((w == 1) + (h == 1) + (d == 1) >= 2)
        {
            row(p, w > 1 ? a : h > 1 ? b : c);
        }
        else if (w == 1)
        {
            flat(p, b, c, a);
        }
        else if (2*w > 3*h && 2*w > 3*d)
        {
            const edge a2 = a.half();
            walk(p, a2, b, c);
            walk(p + a2, a.minus(a2), b, c);
        }
        else if (d == 1 || 3*h > 4*d)
        {
            flat(p, a, b, c);
        }
        else if (h == 1 || 3*d > 4*h)
        {
            flat(p, a, c, b);
        }
        else
        {
            full(p, a, b, c);
        }
    }

    std::vector<int> order;

private:

    void row(place p, const edge& along)
    {
        for (int i = 0; i < along.size(); ++i)
        {
            order.push_back(p.at[0] + n_[0]*(p.at[1] + n_[1]*p.at[2]));
            p = p + along.step();
        }
    }

    //- Halves along a and b; c stays whole
    void flat(const place& p, const edge& a, const edge& b, const edge& c)
    {
        const edge a2 = a.half(), b2 = b.half();
        walk(p, b2, c, a2);
        walk(p + b2, a, b.minus(b2), c);
        walk(p.last(a).last(b2), b2.reversed(), c, a.minus(a2).reversed());
    }

    //- Halves along all three
    void full(const place& p, const edge& a, const edge& b, const edge& c)
    {
        const edge a2 = a.half(), b2 = b.half(), c2 = c.half();
        const edge aRest = a.minus(a2).reversed();
        const edge cRest = c.minus(c2).reversed();
        walk(p, b2, c2, a2);
        walk(p + b2, c, a2, b.minus(b2));
        walk(p.last(b2).last(c), a, b2.reversed(), cRest);
        walk((p + b2).last(a).last(c), c.reversed(), aRest, b.minus(b2));
        walk(p.last(a).last(b2), b2.reversed(), c2, aRest);
    }

    const int (&n_)[3];
};

} // namespace


std::vector<int> hilbertCurve(const int (&n)[3])
{
    edge edges[3] = {{0, n[0]}, {1, n[1]}, {2, n[2]}};
    std::stable_sort
    (
        edges,
        edges + 3,
        [](const edge& a, const edge& b) { return a.length > b.length; }
    );
    walker path(n);
    path.order.reserve(std::size_t(n[0])*n[1]*n[2]);
    path.walk({{0, 0, 0}}, edges[0], edges[1], edges[2]);
    return path.order;
}

} // namespace gpuFsi
