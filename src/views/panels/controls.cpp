#include "views/panels/controls.h"

#include "views/ui/scrublabel.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

namespace autocuts {

namespace {

//! A thin horizontal line that is visible on dark and light windows.
class HeadingLine final : public QWidget
{
protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        QColor color = palette().color(QPalette::WindowText);
        color.setAlphaF(0.25f);
        painter.fillRect(0, height() / 2, width(), 1, color);
    }
};

} // namespace

QFormLayout *makeForm(QWidget *owner)
{
    auto *form = new QFormLayout(owner);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(rowSpacing);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    return form;
}

QLabel *addRow(QFormLayout *form, const QString &label, QWidget *field, const QString &tip)
{
    QAbstractSpinBox *number = spinBoxOf(field);
    auto *caption = number ? new ScrubLabel(label, number) : new QLabel(label);
    caption->setBuddy(field);
    caption->setToolTip(tip);
    // The same in all forms, unless the text needs more.
    caption->setMinimumWidth(
        std::max(caption->fontMetrics().horizontalAdvance(QStringLiteral("Distortion__")),
                 caption->sizeHint().width()));
    field->setToolTip(tip);
    if (field->accessibleName().isEmpty())
        field->setAccessibleName(label);
    field->setMinimumWidth(0);
    form->addRow(caption, field);
    return caption;
}

QPushButton *makeButton(const QString &text, QLatin1StringView name)
{
    auto *button = new QPushButton(text);
    button->setObjectName(name);
    button->setAutoDefault(false);
    // Fusion makes every button wide enough for a long text; here several buttons have to fit side by side.
    button->setMinimumWidth(button->fontMetrics().horizontalAdvance(text) + 20);
    return button;
}

QWidget *makeRow(std::initializer_list<QWidget *> widgets, RowWidths widths)
{
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    for (QWidget *widget : widgets)
        layout->addWidget(widget, widths == RowWidths::Equal ? 1 : 0);
    if (widths == RowWidths::AsNeeded)
        layout->addStretch(1);
    return row;
}

QWidget *makeHeading(const QString &text)
{
    auto *heading = new QWidget;
    auto *layout = new QHBoxLayout(heading);
    layout->setContentsMargins(0, rowSpacing, 0, 0);
    auto *label = new QLabel(text);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    layout->addWidget(label);
    layout->addWidget(new HeadingLine, 1);
    return heading;
}

QLabel *addFigure(QGridLayout *grid, int row, int column, const QString &caption, const QString &tip)
{
    auto *name = new QLabel(caption);
    auto *value = new QLabel;
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAccessibleName(caption);
    name->setToolTip(tip);
    value->setToolTip(tip);
    grid->addWidget(name, row, column);
    grid->addWidget(value, row, column + 1);
    return value;
}

QLabel *makeRemark(const QString &text)
{
    auto *remark = new QLabel(text);
    remark->setWordWrap(true);
    remark->setForegroundRole(QPalette::PlaceholderText);
    return remark;
}

} // namespace autocuts
