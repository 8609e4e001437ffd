#include "decomposedTime.H"

namespace gpuFsi
{

decomposedTime::decomposedTime
(
    const std::filesystem::path& folder,
    const blockGrid& grid,
    const frame& f,
    const decomposeParDict& dict
)
:
    folder_(folder),
    nRanks_(dict.numberOfSubdomains),
    weightOfBlock_(grid.count(), 0)
{
    for (const std::string& cloudName : cloudNames(folder))
    {
        sharedCloud c;
        c.whole = readCloud(folder, cloudName);
        c.form = cloudForm::of(folder, cloudName);
        for (const vector& x : c.whole.positions)
        {
            c.blocks.push_back(grid.blockOf(f, x));
        }
        clouds_.push_back(std::move(c));
    }
    if (clouds_.empty())
    {
        throw userError
        (
            "There is no cloud at time " + name(),
            {folder.string()},
            "Run seedParticles, or give another time."
        );
    }
    weigh(dict.weights);
    rankOfBlock_ = dict.method->assign(grid, weightOfBlock_, nRanks_);
    for (sharedCloud& c : clouds_)
    {
        c.ids.resize(nRanks_);
        for (std::size_t i = 0; i < c.whole.size(); ++i)
        {
            c.ids[c.together() ? 0 : rankOfBlock_[c.blocks[i]]].push_back(i);
        }
    }
}


void decomposedTime::weigh(const decomposeParDict::costs& costs)
{
    for (const sharedCloud& c : clouds_)
    {
        const double one = c.whole.name == "fluid" ? costs.fluid
          : c.whole.name == "walls" ? costs.wall : 0;
        for (int block : c.blocks)
        {
            weightOfBlock_[block] += one;
        }
    }
}


std::vector<std::size_t> decomposedTime::particlesOfBlock() const
{
    std::vector<std::size_t> n(weightOfBlock_.size(), 0);
    for (const sharedCloud& c : clouds_)
    {
        if (!c.together())
        {
            for (int block : c.blocks)
            {
                ++n[block];
            }
        }
    }
    return n;
}

} // namespace gpuFsi
