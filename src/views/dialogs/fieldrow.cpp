#include "views/dialogs/fieldrow.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace autocuts {

QWidget *fieldRow(QWidget *field, QPushButton *button, QWidget *row)
{
    if (!row)
        row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(field, 1);
    layout->addWidget(button);
    button->setAutoDefault(false);
    row->setFocusProxy(field);
    return row;
}

} // namespace autocuts
