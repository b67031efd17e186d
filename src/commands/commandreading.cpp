#include "commands/commandreading.h"

#include <QCoreApplication>

namespace autocuts {

Error damagedCommand()
{
    return {
        QCoreApplication::translate("Journal", "A recorded command is damaged or does not fit the document"),
        {},
        0,
        QCoreApplication::translate("Journal", "Open the session without replaying it")};
}

} // namespace autocuts
