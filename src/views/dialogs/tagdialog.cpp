#include "views/dialogs/tagdialog.h"

#include "views/ui/reasons.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

TagDialog::TagDialog(const QStringList &tags, int islands, QWidget *parent)
    : QDialog(parent), mName(new QComboBox), mHasIslands(islands > 0)
{
    setWindowTitle(tr("Tags of islands"));
    mName->setObjectName("name"_L1);
    mName->setEditable(true);
    mName->addItems(tags);
    mName->setToolTip(tr("A tag that there is, or the name of a new one"));
    mName->lineEdit()->selectAll();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    const auto button = [&](const QString &text, QLatin1StringView name, const QString &toolTip,
                            Choice choice) {
        QPushButton *made = buttons->addButton(text, QDialogButtonBox::AcceptRole);
        made->setObjectName(name);
        made->setToolTip(toolTip);
        connect(made, &QPushButton::clicked, this, [this, choice] {
            mChoice = choice;
            accept();
        });
        return made;
    };
    mTag = button(tr("&Tag"), "tag"_L1, tr("Give the selected islands this tag"), Choice::Tag);
    mUntag = button(tr("&Untag"), "untag"_L1, tr("Take this tag from the selected islands"), Choice::Untag);
    mSelect = button(tr("&Select"), "select"_L1, tr("Select the islands with this tag"), Choice::Select);
    auto *form = new QFormLayout(this);
    form->addRow(new QLabel(tr("Islands selected: %1").arg(islands)));
    form->addRow(tr("&Name:"), mName);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mName, &QComboBox::editTextChanged, this, &TagDialog::enableButtons);
    enableButtons();
    mName->setFocus();
}

QString TagDialog::name() const
{
    return mName->currentText().trimmed();
}

void TagDialog::enableButtons()
{
    const bool isTag = mName->findText(name(), Qt::MatchExactly | Qt::MatchCaseSensitive) >= 0;
    const QString noIslands = mHasIslands ? QString() : tr("Select islands first");
    const QString noTag = isTag ? QString() : tr("There is no such tag");
    disableFor(!noIslands.isEmpty() ? noIslands
               : name().isEmpty()   ? tr("Type a name first")
                                    : QString(),
               mTag);
    disableFor(!noIslands.isEmpty() ? noIslands : noTag, mUntag);
    disableFor(noTag, mSelect);
    (mHasIslands ? mTag : mSelect)->setDefault(true);
}

} // namespace autocuts
