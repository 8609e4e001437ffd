#include "decomposition/decomposition.H"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>

#include <scotch.h>

namespace gpuFsi
{

namespace
{

//- Calls f(neighbour) for the blocks that share a face (in 2-D an edge)
template<class Visit>
void eachBeside(const blockGrid& g, int block, const Visit& f)
{
    const int at[3] =
        {block % g.n[0], block/g.n[0] % g.n[1], block/g.n[0]/g.n[1]};
    for (int d = 0; d < 3; ++d)
    {
        for (int step : {-1, 1})
        {
            int to[3] = {at[0], at[1], at[2]};
            to[d] = g.beside(d, at[d], step);
            const int other =
                to[d] < 0 ? block : g.index(to[0], to[1], to[2]);
            const bool twice = step > 0 && g.n[d] == 2 && g.periodic[d];
            if (other != block && !twice)
            {
                f(other);
            }
        }
    }
}

//- Blocks with weight and what joins them, as Scotch takes a graph
struct blockGraph
{
    std::vector<int> blocks;          // by vertex
    std::vector<SCOTCH_Num> first;    // edge of a vertex; one more at the end
    std::vector<SCOTCH_Num> edges;    // the vertex at the other end
    std::vector<SCOTCH_Num> loads;

    blockGraph(const blockGrid& g, const std::vector<double>& weights)
    {
        const double all =
            std::accumulate(weights.begin(), weights.end(), 0.0);
        std::vector<SCOTCH_Num> vertex(g.count(), -1);
        for (int b = 0; b < g.count(); ++b)
        {
            if (weights[b] > 0)
            {
                vertex[b] = SCOTCH_Num(blocks.size());
                blocks.push_back(b);
                // Whole numbers whose sum stays well below 2^31
                loads.push_back
                (
                    1 + SCOTCH_Num(std::lround(2e8*weights[b]/all))
                );
            }
        }
        for (int b : blocks)
        {
            first.push_back(SCOTCH_Num(edges.size()));
            eachBeside(g, b, [&](int other)
            {
                if (vertex[other] >= 0)
                {
                    edges.push_back(vertex[other]);
                }
            });
        }
        first.push_back(SCOTCH_Num(edges.size()));
    }
};

//- What Scotch refuses is not the user's doing
void check(int status, const char* what)
{
    if (status != 0)
    {
        throw userError
        (
            std::string("Scotch fails in ") + what,
            {},
            "Use method hilbert, and report this case."
        );
    }
}

//- One thread and always the same seed: the same parts on every machine
class scotchPartition
{
public:

    explicit scotchPartition(blockGraph& g)
    {
        SCOTCH_graphInit(&graph_);
        SCOTCH_stratInit(&strategy_);
        check
        (
            SCOTCH_graphBuild
            (
                &graph_, 0, SCOTCH_Num(g.blocks.size()), g.first.data(),
                nullptr, g.loads.data(), nullptr,
                SCOTCH_Num(g.edges.size()), g.edges.data(), nullptr
            ),
            "graphBuild"
        );
    }

    ~scotchPartition()
    {
        SCOTCH_stratExit(&strategy_);
        SCOTCH_graphExit(&graph_);
    }

    scotchPartition(const scotchPartition&) = delete;
    scotchPartition& operator=(const scotchPartition&) = delete;

    std::vector<SCOTCH_Num> parts(std::size_t size, int nRanks)
    {
        check
        (
            SCOTCH_stratGraphMapBuild
            (
                &strategy_, SCOTCH_STRATQUALITY, nRanks, 0.01
            ),
            "stratGraphMapBuild"
        );
        std::vector<SCOTCH_Num> part(size);
#if SCOTCH_VERSION >= 7
        SCOTCH_Context context;
        SCOTCH_Graph bound;
        SCOTCH_contextInit(&context);
        SCOTCH_contextThreadSpawn(&context, 1, nullptr);
        SCOTCH_contextRandomSeed(&context, 1);
        SCOTCH_contextRandomReset(&context);
        SCOTCH_graphInit(&bound);
        SCOTCH_contextBindGraph(&context, &graph_, &bound);
        const int status =
            SCOTCH_graphPart(&bound, nRanks, &strategy_, part.data());
        SCOTCH_graphExit(&bound);
        SCOTCH_contextExit(&context);
#else
        SCOTCH_randomReset();
        const int status =
            SCOTCH_graphPart(&graph_, nRanks, &strategy_, part.data());
#endif
        check(status, "graphPart");
        return part;
    }

private:

    SCOTCH_Graph graph_;
    SCOTCH_Strat strategy_;
};

//- Blocks without weight go to the rank they are nearest to
void spread(const blockGrid& g, std::vector<int> front, std::vector<int>& ranks)
{
    while (!front.empty())
    {
        std::vector<int> next;
        for (int b : front)
        {
            eachBeside(g, b, [&](int other)
            {
                if (ranks[other] < 0)
                {
                    ranks[other] = ranks[b];
                    next.push_back(other);
                }
            });
        }
        front.swap(next);
    }
}

//- Parts that cut few faces between blocks with particles
class scotchDecomposition
:
    public decomposition
{
public:

    explicit scotchDecomposition(const decompositionInput&) {}

    std::vector<int> assign
    (
        const blockGrid& g,
        const std::vector<double>& weightOfBlock,
        int nRanks
    ) const override
    {
        const bool any = std::accumulate
        (
            weightOfBlock.begin(), weightOfBlock.end(), 0.0
        ) > 0;
        blockGraph graph
        (
            g, any ? weightOfBlock : std::vector<double>(g.count(), 1)
        );
        std::vector<SCOTCH_Num> part(graph.blocks.size());
        if (nRanks >= int(part.size()))
        {
            std::iota(part.begin(), part.end(), 0);
        }
        else if (nRanks > 1)
        {
            part = scotchPartition(graph).parts(part.size(), nRanks);
        }
        std::vector<int> ranks(g.count(), -1);
        for (std::size_t v = 0; v < part.size(); ++v)
        {
            ranks[graph.blocks[v]] = int(part[v]);
        }
        spread(g, graph.blocks, ranks);
        return ranks;
    }
};

const decomposition::selection::add<scotchDecomposition> add("scotch");

} // namespace

} // namespace gpuFsi
