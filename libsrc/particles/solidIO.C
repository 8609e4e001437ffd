#include "particles/solidIO.H"

#include "particles/needField.H"

#include <numeric>

namespace gpuFsi
{

namespace fs = std::filesystem;

solidSet readSolidSet(const fs::path& time, const domain& d)
{
    solidSet s;
    if (d.solids.empty())
    {
        return s;
    }
    const cloud c = readCloud(time, "solid");
    s.names = d.solids;
    s.positions = c.positions;
    s.U = vectorsOf(needField(c, "U", "vectorField", time));
    if (c.find("acceleration"))
    {
        s.accelerations =
            vectorsOf(needField(c, "acceleration", "vectorField", time));
    }
    if (c.find("brokenBonds"))
    {
        const auto& masks =
            needField(c, "brokenBonds", "labelField", time).values;
        s.broken.assign(masks.begin(), masks.end());
    }
    return s;
}


static void addTensor
(
    cloud& c,
    const char* name,
    const std::vector<symmetricTensor>& values
)
{
    cloudField f{"symmTensorField", name, {}};
    f.values.reserve(6*values.size());
    for (const symmetricTensor& t : values)
    {
        f.values.insert(f.values.end(), t.begin(), t.end());
    }
    c.fields.push_back(std::move(f));
}


static std::vector<vector> displacement(const solidSet& s)
{
    std::vector<vector> d(s.size());
    for (std::size_t i = 0; i < d.size(); ++i)
    {
        d[i] = s.positions[i] - s.reference[i];
    }
    return d;
}


std::size_t writeSolidSet
(
    const fs::path& time,
    const solidSet& s,
    bool withIds,
    const writeOptions& options
)
{
    if (s.size() == 0 && !(withIds && !s.names.empty()))
    {
        return 0;
    }
    cloud c;
    c.name = "solid";
    c.positions = s.positions;
    c.addVector("U", s.U);
    c.addVector("acceleration", s.accelerations);
    c.addVector("referencePosition", s.reference);
    c.addVector("displacement", displacement(s));
    c.addVector("force", s.load);
    c.addScalar("rho", s.rho);
    c.addScalar("vonMises", s.vonMises);
    addTensor(c, "stress", s.stress);
    addTensor(c, "strain", s.strain);
    if (s.touch)
    {
        c.addVector("contactForce", s.contact);
    }
    if (s.bondsBreak)
    {
        c.addLabel("brokenBonds", {s.broken.begin(), s.broken.end()});
    }
    c.addLabel("solid", {s.solid.begin(), s.solid.end()});
    if (withIds)
    {
        std::vector<double> ids(s.size());
        std::iota(ids.begin(), ids.end(), 0);
        c.addLabel("origId", std::move(ids));
    }
    // A place that is rounded would be a strain
    writeOptions exact = options;
    exact.precision = 17;
    return writeCloud(time, c, exact);
}

} // namespace gpuFsi
