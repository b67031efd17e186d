// The panel of the undo history.
#pragma once

#include "views/panels/panel.h"

class QLabel;

namespace autocuts {

class HistoryView;

//! Lists what was done, with the saved state marked; a click goes there. Entries that gave up their contents
//! for lack of memory are grey and cannot be gone back to.
class HistoryPanel final : public Panel
{
    Q_OBJECT

public:
    explicit HistoryPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    void replaceStack();

    HistoryView *mView;
    QLabel *mMemory;
};

} // namespace autocuts
