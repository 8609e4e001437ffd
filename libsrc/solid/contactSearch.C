#include "solid/contactSearch.H"

#include "base/error.H"

#include <fmt/format.h>
#include <limits>

namespace gpuFsi
{

namespace
{

//- Centres of the faces and the largest distance of a corner from its own
double centresOf
(
    const contactSurface& s,
    const std::vector<vector>& x,
    std::vector<vector>& centres
)
{
    const int N = s.corners();
    double radius = 0;
    for (int f = 0; f < s.nFaces(); ++f)
    {
        const vector& first = x[s.faceCorners[f*N]];
        vector sum{0, 0, 0};
        for (int a = 1; a < N; ++a)
        {
            sum += s.image.offset(x[s.faceCorners[f*N + a]], first);
        }
        centres.push_back(first + (1.0/N)*sum);
        for (int a = 0; a < N; ++a)
        {
            const vector d = s.image.offset
            (
                x[s.faceCorners[f*N + a]], centres.back()
            );
            radius = std::max(radius, std::sqrt(dot(d, d)));
        }
    }
    return radius;
}


//- Nodes by face from faces by node
void invert(int nFaces, contactCandidates& c)
{
    c.nodeBegin.assign(nFaces + 1, 0);
    for (const int f : c.face)
    {
        ++c.nodeBegin[f + 1];
    }
    for (int f = 0; f < nFaces; ++f)
    {
        c.nodeBegin[f + 1] += c.nodeBegin[f];
    }
    std::vector<int> next(c.nodeBegin.begin(), c.nodeBegin.end() - 1);
    c.node.resize(c.face.size());
    for (std::size_t n = 0; n + 1 < c.faceBegin.size(); ++n)
    {
        for (int k = c.faceBegin[n]; k < c.faceBegin[n + 1]; ++k)
        {
            c.node[next[c.face[k]]++] = int(n);
        }
    }
}

} // namespace


int contactRowEnd(std::size_t size)
{
    constexpr int most = std::numeric_limits<int>::max();
    if (size > std::size_t(most))
    {
        throw userError
        (
            fmt::format
            (
                "Contact has more than {} candidates: pairs of surface "
                "particles and faces or wall particles near them", most
            ),
            {},
            "Lower gap and margin in contact, or deltaT."
        );
    }
    return int(size);
}


void contactSearch::findFaces
(
    const std::vector<vector>& x,
    double reach,
    contactCandidates& c
) const
{
    const contactSurface& s = surface_;
    std::vector<vector> centres;
    const double within = reach + centresOf(s, x, centres);
    const contactGrid grid(centres, within, s.image.period);
    for (int n = 0; n < s.nNodes(); ++n)
    {
        const vector& here = x[s.node[n]];
        grid.forNear(here, [&](int f)
        {
            const vector d = s.image.offset(here, centres[f]);
            if (s.faceSolid[f] != s.solid[n] && dot(d, d) <= within*within)
            {
                c.face.push_back(f);
            }
        });
        std::sort(c.face.begin() + c.faceBegin.back(), c.face.end());
        c.faceBegin.push_back(contactRowEnd(c.face.size()));
    }
}


void contactSearch::findWalls
(
    const std::vector<vector>& x,
    const std::vector<vector>& places,
    double reach,
    contactCandidates& c
)
{
    const contactSurface& s = surface_;
    if (!grid_ || walls_.move() || reach > gridReach_)
    {
        grid_ = std::make_unique<contactGrid>(places, reach, s.image.period);
        gridReach_ = reach;
    }
    for (int n = 0; n < s.nNodes(); ++n)
    {
        const vector& here = x[s.node[n]];
        grid_->forNear(here, [&](int k)
        {
            const vector d = s.image.offset(here, places[k]);
            if (!s.held[n] && dot(d, d) <= reach*reach)
            {
                c.wall.push_back(k);
            }
        });
        std::sort(c.wall.begin() + c.wallBegin.back(), c.wall.end());
        c.wallBegin.push_back(contactRowEnd(c.wall.size()));
    }
}


contactCandidates contactSearch::find
(
    const std::vector<vector>& x,
    const std::vector<vector>& wallPlaces,
    double reach,
    double wallReach
)
{
    contactCandidates c;
    c.faceBegin.push_back(0);
    c.wallBegin.push_back(0);
    if (surface_.nSolids > 1)
    {
        findFaces(x, reach, c);
    }
    c.faceBegin.resize(surface_.nNodes() + 1, 0);
    invert(surface_.nFaces(), c);
    if (!walls_.empty())
    {
        findWalls(x, wallPlaces, wallReach, c);
    }
    c.wallBegin.resize(surface_.nNodes() + 1, 0);
    return c;
}

} // namespace gpuFsi
