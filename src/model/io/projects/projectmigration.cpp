#include "model/io/projects/projectmigration.h"

#include <algorithm>

namespace autocuts {

const std::vector<Migration> &projectMigrations()
{
    static const std::vector<Migration> migrations{
        // Version 1 stored edges in the journal and in the selection by number. These blocks say which form
        // they use, and their readers convert it, because that needs the mesh.
        [](PartMap &) { return true; }};
    return migrations;
}

bool migrateParts(PartMap &parts, int version, const std::vector<Migration> &migrations)
{
    if (version > static_cast<int>(migrations.size()) + 1)
        return false;
    return std::all_of(migrations.begin() + (version - 1), migrations.end(),
                       [&](const Migration &migrate) { return migrate(parts); });
}

} // namespace autocuts
