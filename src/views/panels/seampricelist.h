// The list of the map's seams with their prices.
#pragma once

#include "views/control/jobs/mapcontroller.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace autocuts {

//! Lists seams with the length that each costs and the distortion that the map would have without it; the
//! cheapest to drop first, then those that cannot be dropped. Does not use the document; what the user asks
//! for is emitted as signals.
class SeamPriceList final : public QWidget
{
    Q_OBJECT

public:
    explicit SeamPriceList(QWidget *parent = nullptr);

    //! \param prices null: they are not known
    //! \param maxDistortion the bound; seams that can be dropped within it are marked
    void setPrices(const unwrap::SeamPrices *prices, double maxDistortion);
    //! Whether prices can be asked for now.
    void setCanPrice(bool can);

Q_SIGNALS:
    void pricesWanted();
    //! The edges are to be selected.
    void picked(const std::vector<int> &edges);
    //! The seam is to be closed.
    void dropped(const std::vector<int> &edges);
    //! The proposed seam is to be cut.
    void added(const std::vector<int> &edges);

private:
    void showChoice();
    void dropCurrent();
    void proposeDrop();
    void proposeAdd();
    const unwrap::SeamPrice *current() const;

    unwrap::SeamPrices mPrices;
    QTreeWidget *mList;
    QPushButton *mPrice, *mDrop, *mNextDrop, *mNextAdd;
    QLabel *mRemark;
};

} // namespace autocuts
