#include "solver/linear/frontalstructure.h"

#include <algorithm>
#include <numeric>

namespace autocuts::linear {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Most nodes that a supernode eliminates, and the size up to which two supernodes are always merged.
constexpr int mostNodes = largestFront / 2;
constexpr int fewNodes = 4;
//! Largest share of explicit zeros that merging supernodes may bring into a front.
constexpr double zerosAllowed = 0.25;

//! Columns of the lower triangle below the diagonal, in nodes: rows[begin[j]] ... rows[begin[j + 1] - 1],
//! ascending.
struct Graph
{
    std::vector<int> begin{0}, rows;
    int count() const { return static_cast<int>(begin.size()) - 1; }
};

Graph nodeGraph(const LinearSolver::Matrix &lower)
{
    Graph graph;
    graph.rows.reserve(static_cast<std::size_t>(lower.nonZeros()) / 4);
    const int *start = lower.outerIndexPtr();
    const int *index = lower.innerIndexPtr();
    for (int j = 0; j < lower.cols() / 2; ++j) {
        for (int k = start[2 * j] + 2; k < start[2 * j + 1]; k += 2)
            graph.rows.push_back(index[k] / 2);
        graph.begin.push_back(static_cast<int>(graph.rows.size()));
    }
    return graph;
}

//! Parent of each node in the elimination tree (Liu 1990).
std::vector<int> eliminationTree(const Graph &graph)
{
    const int n = graph.count();
    // The columns of each row.
    std::vector<int> rowBegin(n + 1, 0);
    for (const int row : graph.rows)
        ++rowBegin[row + 1];
    std::partial_sum(rowBegin.begin(), rowBegin.end(), rowBegin.begin());
    std::vector<int> columns(graph.rows.size()), next(rowBegin.begin(), rowBegin.end() - 1);
    for (int j = 0; j < n; ++j) {
        for (int k = graph.begin[j]; k < graph.begin[j + 1]; ++k)
            columns[next[graph.rows[k]]++] = j;
    }
    std::vector<int> parent(n, -1), ancestor(n, -1);
    for (int i = 0; i < n; ++i) {
        for (int k = rowBegin[i]; k < rowBegin[i + 1]; ++k) {
            int j = columns[k];
            while (j >= 0 && j < i) {
                const int above = ancestor[j];
                ancestor[j] = i;
                if (above < 0)
                    parent[j] = i;
                j = above;
            }
        }
    }
    return parent;
}

//! Lists of integers, one per owner.
struct Lists
{
    std::vector<int> head, next;

    Lists(int owners, int items) : head(owners, -1), next(items, -1) {}
    void push(int owner, int item)
    {
        next[item] = head[owner];
        head[owner] = item;
    }
};

//! A supernode during construction, in the original numbers.
struct Group
{
    int firstColumn, lastColumn, columns; //!< columns linked by nextColumn
    int rowBegin, rowEnd;                 //!< range of its rows in the common pool, ascending
    int parent = -1;
    double zeros = 0;
    int rows() const { return rowEnd - rowBegin; }
};

struct GroupTree
{
    std::vector<Group> groups;
    std::vector<int> nextColumn; //!< per column
    std::vector<int> pool;       //!< rows of all groups
};

//! Fundamental supernodes: a column joins its child when both have the same rows below the column.
GroupTree fundamentalGroups(const Graph &graph, const std::vector<int> &parent)
{
    const int n = graph.count();
    GroupTree tree;
    tree.nextColumn.assign(n, -1);
    Lists children(n, n);
    for (int j = n - 1; j >= 0; --j) {
        if (parent[j] >= 0)
            children.push(parent[j], j);
    }
    std::vector<int> groupOf(n, -1), mark(n, -1), rows;
    for (int j = 0; j < n; ++j) {
        rows.clear();
        mark[j] = j;
        const auto add = [&](int row) {
            if (mark[row] != j) {
                mark[row] = j;
                rows.push_back(row);
            }
        };
        std::for_each(graph.rows.begin() + graph.begin[j], graph.rows.begin() + graph.begin[j + 1], add);
        int largest = -1;
        for (int child = children.head[j]; child >= 0; child = children.next[child]) {
            const Group &group = tree.groups[groupOf[child]];
            std::for_each(tree.pool.begin() + group.rowBegin, tree.pool.begin() + group.rowEnd, add);
            if (largest < 0 || group.rows() > tree.groups[largest].rows())
                largest = groupOf[child];
        }
        if (largest >= 0 && tree.groups[largest].rows() == static_cast<int>(rows.size()) + 1) {
            Group &group = tree.groups[largest];
            groupOf[j] = largest;
            tree.nextColumn[group.lastColumn] = j;
            group.lastColumn = j;
            ++group.columns;
            ++group.rowBegin; // that row was j itself
            continue;
        }
        std::sort(rows.begin(), rows.end());
        groupOf[j] = static_cast<int>(tree.groups.size());
        const int begin = static_cast<int>(tree.pool.size());
        tree.pool.insert(tree.pool.end(), rows.begin(), rows.end());
        tree.groups.push_back({j, j, 1, begin, static_cast<int>(tree.pool.size())});
    }
    for (Group &group : tree.groups) {
        if (group.rows() > 0)
            group.parent = groupOf[tree.pool[group.rowBegin]];
    }
    return tree;
}

//! Merges small groups into their parents where that adds few zeros. Merged groups are left without columns.
void amalgamate(GroupTree &tree)
{
    std::vector<Group> &groups = tree.groups;
    // Children before parents, ordered by their last columns: a group that was made early may have gained
    // later columns.
    std::vector<int> endingAt(tree.nextColumn.size(), -1), mergedInto(groups.size(), -1);
    for (std::size_t g = 0; g < groups.size(); ++g)
        endingAt[groups[g].lastColumn] = static_cast<int>(g);
    for (const int g : endingAt) {
        if (g < 0 || groups[g].parent < 0)
            continue;
        Group &child = groups[g];
        Group &parent = groups[child.parent];
        const double c = child.columns, p = parent.columns;
        if (c + p > mostNodes)
            continue;
        const double zeros = child.zeros + parent.zeros + c * (p + parent.rows() - child.rows());
        const double size = (c + p) * (0.5 * (c + p) + parent.rows());
        if (zeros > zerosAllowed * size && c + p > fewNodes)
            continue;
        parent.zeros = zeros;
        tree.nextColumn[child.lastColumn] = parent.firstColumn;
        parent.firstColumn = child.firstColumn;
        parent.columns += child.columns;
        child.columns = 0;
        mergedInto[g] = child.parent;
    }
    for (Group &group : groups) {
        while (group.parent >= 0 && mergedInto[group.parent] >= 0)
            group.parent = mergedInto[group.parent];
    }
}

//! Groups that still have columns, depth first: children before parents, each subtree in consecutive places.
std::vector<int> postorder(const std::vector<Group> &groups)
{
    const int count = static_cast<int>(groups.size());
    Lists children(count + 1, count); // the last owner holds the roots
    for (int g = count - 1; g >= 0; --g) {
        if (groups[g].columns > 0)
            children.push(groups[g].parent >= 0 ? groups[g].parent : count, g);
    }
    std::vector<int> order, stack;
    for (int root = children.head[count]; root >= 0; root = children.next[root]) {
        stack.push_back(root);
        while (!stack.empty()) {
            const int group = stack.back();
            const int child = children.head[group];
            if (child >= 0) {
                children.head[group] = children.next[child];
                stack.push_back(child);
            } else {
                order.push_back(group);
                stack.pop_back();
            }
        }
    }
    return order;
}

//! Makes supernodes of at most mostNodes nodes each: a larger group becomes a chain of them.
void makeSupernodes(const GroupTree &tree, FrontalStructure &s)
{
    const std::vector<int> order = postorder(tree.groups);
    s.newNumber.assign(s.nodeCount, -1);
    int number = 0;
    for (const int g : order) {
        const Group &group = tree.groups[g];
        for (int i = 0, column = group.firstColumn; i < group.columns; ++i, column = tree.nextColumn[column])
            s.newNumber[column] = number++;
    }
    std::vector<int> firstOf(tree.groups.size(), -1), lastOf(tree.groups.size(), -1), rows;
    for (const int g : order) {
        const Group &group = tree.groups[g];
        rows.clear();
        for (int i = group.rowBegin; i < group.rowEnd; ++i)
            rows.push_back(s.newNumber[tree.pool[i]]);
        std::sort(rows.begin(), rows.end());
        const int size = group.columns;
        const int parts = (size + mostNodes - 1) / mostNodes;
        const int first = s.newNumber[group.firstColumn];
        firstOf[g] = static_cast<int>(s.supernodes.size());
        for (int part = 0; part < parts; ++part) {
            const int from = first + size * part / parts, to = first + size * (part + 1) / parts;
            FrontalStructure::Supernode node;
            node.first = from;
            node.count = to - from;
            node.rowBegin = static_cast<int>(s.rows.size());
            for (int later = to; later < first + size; ++later)
                s.rows.push_back(later);
            s.rows.insert(s.rows.end(), rows.begin(), rows.end());
            node.rowCount = static_cast<int>(s.rows.size()) - node.rowBegin;
            node.parent = part + 1 < parts ? static_cast<int>(s.supernodes.size()) + 1 : -1;
            s.supernodes.push_back(node);
        }
        lastOf[g] = static_cast<int>(s.supernodes.size()) - 1;
    }
    for (const int g : order) {
        if (tree.groups[g].parent >= 0)
            s.supernodes[lastOf[g]].parent = firstOf[tree.groups[g].parent];
    }
}

void placeChildren(FrontalStructure &s)
{
    s.childBegin.assign(s.supernodes.size() + 1, 0);
    s.runBegin.assign(1, 0);
    for (const auto &node : s.supernodes) {
        if (node.parent >= 0) {
            ++s.childBegin[node.parent + 1];
            const FrontalStructure::Supernode &parent = s.supernodes[node.parent];
            // Both lists are ascending, so one pass is enough.
            int at = parent.rowBegin, next = -1; // place that would continue the run
            for (int i = 0; i < node.rowCount; ++i) {
                const int number = s.rows[node.rowBegin + i];
                int place = number - parent.first;
                if (place >= parent.count) {
                    while (s.rows[at] != number)
                        ++at;
                    place = parent.count + at - parent.rowBegin;
                }
                if (place != next || place == parent.count)
                    s.runs.push_back({2 * i, 2 * i, 2 * place});
                s.runs.back().end = 2 * i + 2;
                next = place + 1;
            }
        }
        s.runBegin.push_back(static_cast<int>(s.runs.size()));
    }
    std::partial_sum(s.childBegin.begin(), s.childBegin.end(), s.childBegin.begin());
    s.children.resize(s.childBegin.back());
    std::vector<int> next(s.childBegin.begin(), s.childBegin.end() - 1);
    for (int n = 0; n < static_cast<int>(s.supernodes.size()); ++n) {
        if (s.supernodes[n].parent >= 0)
            s.children[next[s.supernodes[n].parent]++] = n;
    }
}

void placeEntries(const LinearSolver::Matrix &lower, const Graph &graph, FrontalStructure &s)
{
    std::vector<int> column(s.nodeCount), place(s.nodeCount);
    for (int j = 0; j < s.nodeCount; ++j)
        column[s.newNumber[j]] = j;
    const int *start = lower.outerIndexPtr();
    s.entryBegin.assign(1, 0);
    s.entries.reserve(graph.rows.size() + s.nodeCount);
    for (const FrontalStructure::Supernode &node : s.supernodes) {
        for (int i = 0; i < node.count; ++i)
            place[node.first + i] = i;
        for (int i = 0; i < node.rowCount; ++i)
            place[s.rows[node.rowBegin + i]] = node.count + i;
        // The rows of a column are its ancestors, which are eliminated later in both orders.
        for (int i = 0; i < node.count; ++i) {
            const int j = column[node.first + i];
            s.entries.push_back({start[2 * j], start[2 * j + 1] - 1, i, i});
            for (int k = graph.begin[j]; k < graph.begin[j + 1]; ++k) {
                const int offset = 2 * (k - graph.begin[j]);
                s.entries.push_back({start[2 * j] + 2 + offset, start[2 * j + 1] + 1 + offset, i,
                                     place[s.newNumber[graph.rows[k]]]});
            }
        }
        s.entryBegin.push_back(static_cast<int>(s.entries.size()));
    }
}

} // namespace

FrontalStructure FrontalStructure::build(const LinearSolver::Matrix &lower)
{
    FrontalStructure s;
    const Graph graph = nodeGraph(lower);
    s.nodeCount = graph.count();
    GroupTree tree = fundamentalGroups(graph, eliminationTree(graph));
    amalgamate(tree);
    makeSupernodes(tree, s);
    placeChildren(s);
    placeEntries(lower, graph, s);
    return s;
}

} // namespace autocuts::linear
