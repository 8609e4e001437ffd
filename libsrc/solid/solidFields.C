#include "solid/solidFields.H"

#include "base/sum.H"
#include "solid/cellShape.H"

#include <algorithm>

namespace gpuFsi
{

namespace
{

struct gradient
{
    vector rows[3]{};    // F_iJ, row i
};


const gradient unstrained{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};


//- Mean over the cell: sum x_a dV0/dX_a/V0 exactly
void addCell
(
    const springNetwork& net,
    const std::vector<vector>& x,
    int slot,
    double share,
    gradient& F
)
{
    const int N = net.nCorners(), first = slot/N*N;
    for (int a = 0; a < N; ++a)
    {
        const vector d = net.image.offset
        (
            x[net.corners[first + a]], x[net.corners[first]]
        );
        const vector B = share*net.restGradient[first + a];
        F.rows[0] += d.x*B;
        F.rows[1] += d.y*B;
        F.rows[2] += d.z*B;
    }
}


//- held: the share of the cells' volume whose bonds hold; without any the
//  particle is unstrained
gradient nodalGradient
(
    const springNetwork& net,
    const std::vector<vector>& x,
    const std::vector<double>& shares,
    int i,
    double& held
)
{
    gradient F;
    double volume = 0, all = 0;
    for (int c = net.cellBegin[i]; c < net.cellBegin[i + 1]; ++c)
    {
        const int cell = net.cellSlot[c]/net.nCorners();
        addCell(net, x, net.cellSlot[c], shares[cell], F);
        volume += shares[cell]*net.volume[cell];
        all += net.volume[cell];
    }
    held = volume/all;
    if (!(volume > 0))
    {
        return unstrained;
    }
    for (vector& row : F.rows)
    {
        row = (1/volume)*row;
    }
    if (net.dimensions == 2)
    {
        F.rows[2] = {0, 0, 1};
    }
    return F;
}


symmetricTensor greenStrain(const gradient& F)
{
    const auto column = [&](int c)
    {
        const auto at = [&](const vector& r)
        {
            return c == 0 ? r.x : c == 1 ? r.y : r.z;
        };
        return vector{at(F.rows[0]), at(F.rows[1]), at(F.rows[2])};
    };
    const vector a = column(0), b = column(1), c = column(2);
    return
    {
        (dot(a, a) - 1)/2, dot(a, b)/2, dot(a, c)/2,
        (dot(b, b) - 1)/2, dot(b, c)/2, (dot(c, c) - 1)/2
    };
}


//- F S F^T/J
symmetricTensor cauchyStress
(
    const gradient& F,
    const symmetricTensor& E,
    double lambda,
    double mu,
    double J
)
{
    const double trace = lambda*(E[0] + E[3] + E[5]);
    const vector S[3] =
    {
        {trace + 2*mu*E[0], 2*mu*E[1], 2*mu*E[2]},
        {2*mu*E[1], trace + 2*mu*E[3], 2*mu*E[4]},
        {2*mu*E[2], 2*mu*E[4], trace + 2*mu*E[5]}
    };
    const auto component = [&](int i, int j)
    {
        const vector& r = F.rows[j];
        const vector Sr{dot(S[0], r), dot(S[1], r), dot(S[2], r)};
        return dot(F.rows[i], Sr)/J;
    };
    return
    {
        component(0, 0), component(0, 1), component(0, 2),
        component(1, 1), component(1, 2), component(2, 2)
    };
}


double vonMisesOf(const symmetricTensor& s)
{
    const double a = s[0] - s[3], b = s[3] - s[5], c = s[5] - s[0];
    return std::sqrt
    (
        0.5*(a*a + b*b + c*c)
      + 3*(s[1]*s[1] + s[2]*s[2] + s[4]*s[4])
    );
}


double springEnergy
(
    const springNetwork& net,
    const std::vector<vector>& x,
    const std::vector<bondMask>& broken,
    std::size_t i
)
{
    double sum = 0;
    for (int b = net.bondBegin[i]; b < net.bondBegin[i + 1]; ++b)
    {
        if (isBroken(net, broken, int(i), b))
        {
            continue;
        }
        const vector d = net.image.offset(x[net.bondTo[b]], x[i]);
        const double stretch = std::sqrt(dot(d, d)) - net.bondLength[b];
        sum += net.bondK[b]*stretch*stretch/4;
    }
    return sum;
}


double cellEnergy
(
    const springNetwork& net,
    const std::vector<vector>& x,
    std::size_t cell
)
{
    const int N = net.nCorners();
    vector d[8];
    for (int a = 0; a < N; ++a)
    {
        d[a] = net.image.offset
        (
            x[net.corners[cell*N + a]], x[net.corners[cell*N]]
        );
    }
    const double V0 = net.volume[cell];
    const double V = net.dimensions == 2
      ? cellShape<2>::volume(d) : cellShape<3>::volume(d);
    return net.cellKappa[cell]*(V - V0)*(V - V0)/(2*V0);
}

} // namespace


void addSolidFields
(
    const solidMesh& mesh,
    const solidProperties& properties,
    const springNetwork& net,
    hostSolid& s
)
{
    s.stress.resize(net.n);
    s.strain.resize(net.n);
    s.vonMises.resize(net.n);
    s.rho.resize(net.n);
    const std::vector<double> shares = cellShares(net, s.broken);
    for (int i = 0; i < net.n; ++i)
    {
        const solidMaterial& m = properties.materials[mesh.solid[i]];
        const double mu = net.springModulus[mesh.solid[i]];
        const double lambda = mu + m.kappa;
        double held = 1;
        const gradient F = nodalGradient(net, s.positions, shares, i, held);
        const double J = dot(F.rows[0], cross(F.rows[1], F.rows[2]));
        s.strain[i] = greenStrain(F);
        s.stress[i] = cauchyStress(F, s.strain[i], lambda, mu, J);
        if (m.planeStress)
        {
            // lambda* (e1 + e2) = -2 mu e3
            s.strain[i][5] =
                -lambda/(2*mu)*(s.strain[i][0] + s.strain[i][3]);
            s.stress[i][5] = 0;
        }
        for (double& component : s.stress[i])
        {
            component *= held;
        }
        s.vonMises[i] = vonMisesOf(s.stress[i]);
        s.rho[i] = m.rho/J;
    }
}


static double anchorEnergy
(
    const springNetwork& net,
    const std::vector<vector>& x,
    std::size_t i
)
{
    const vector d = net.image.offset(x[i], net.rest[i]);
    const vector& k = net.anchor[i];
    return 0.5*(k.x*d.x*d.x + k.y*d.y*d.y + k.z*d.z*d.z);
}


double elasticEnergy
(
    const springNetwork& net,
    const std::vector<vector>& x,
    const std::vector<bondMask>& broken
)
{
    double springs = pairwiseSum
    (
        0, net.n,
        [&](std::size_t i) { return springEnergy(net, x, broken, i); }
    );
    if (!net.anchor.empty())
    {
        springs += pairwiseSum
        (
            0, net.n, [&](std::size_t i) { return anchorEnergy(net, x, i); }
        );
    }
    const std::vector<double> shares = cellShares(net, broken);
    return !net.stiffened ? springs : springs + pairwiseSum
    (
        0, net.nCells(),
        [&](std::size_t c) { return shares[c]*cellEnergy(net, x, c); }
    );
}

} // namespace gpuFsi
