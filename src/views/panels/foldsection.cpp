#include "views/panels/foldsection.h"

#include "views/panels/controls.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace autocuts {

FoldSection::FoldSection(const QString &title, QWidget *content, QWidget *parent)
    : QWidget(parent), mHeading(new QToolButton), mContent(content)
{
    mHeading->setText(title);
    mHeading->setCheckable(true);
    mHeading->setAutoRaise(true);
    mHeading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    mHeading->setArrowType(Qt::RightArrow);
    mHeading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    mHeading->setToolTip(tr("Show or hide what follows"));
    QFont bold = mHeading->font();
    bold.setBold(true);
    mHeading->setFont(bold);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing + 2);
    layout->addWidget(mHeading);
    layout->addWidget(mContent);
    mContent->hide();
    connect(mHeading, &QToolButton::toggled, this, [this](bool open) {
        mHeading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        mContent->setVisible(open);
    });
}

bool FoldSection::isOpen() const
{
    return mHeading->isChecked();
}

void FoldSection::setOpen(bool open)
{
    mHeading->setChecked(open);
}

} // namespace autocuts
