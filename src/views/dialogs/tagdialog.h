// A dialog that asks for a tag of islands and what to do with it.
#pragma once

#include <QDialog>
#include <QStringList>

class QComboBox;
class QPushButton;

namespace autocuts {

//! Asks for the name of a tag, and whether islands get it, lose it or are selected by it.
class TagDialog final : public QDialog
{
    Q_OBJECT

public:
    enum class Choice { Tag, Untag, Select };

    //! \param tags the names of all tags \param islands number of selected islands
    TagDialog(const QStringList &tags, int islands, QWidget *parent = nullptr);

    QString name() const;
    Choice choice() const { return mChoice; }

private:
    void enableButtons();

    QComboBox *mName;
    QPushButton *mTag, *mUntag, *mSelect;
    bool mHasIslands;
    Choice mChoice = Choice::Tag;
};

} // namespace autocuts
