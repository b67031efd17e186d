// The panel with the UV sets of the model.
#pragma once

#include "views/panels/panel.h"

class QListWidget;
class QListWidgetItem;

namespace autocuts {

//! A list of the UV sets, with the names of the file; the chosen one is edited and shown.
class UvSetPanel final : public Panel
{
    Q_OBJECT

public:
    explicit UvSetPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    void choose(int row);
    void rename(const QListWidgetItem &item);

    QListWidget *mList;
    bool mShowing = false; //!< the list changes, not the document
};

} // namespace autocuts
