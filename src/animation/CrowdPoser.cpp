#include "animation/CrowdPoser.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace walkcycle {

class CrowdPoser::Workers {
public:
    Workers(const FastPoser& poser, unsigned int threads) : posers_(std::max(1u, threads), poser) {
        for (std::size_t i = 1; i < posers_.size(); ++i) threads_.emplace_back([this, i] { workOn(i); });
    }

    ~Workers() {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        begin_.notify_all();
    }

    std::size_t paletteSize() const { return posers_.front().paletteSize(); }

    void pose(std::span<const double> seconds, std::span<JointRows> palettes) {
        {
            const std::lock_guard lock(mutex_);
            seconds_ = seconds;
            palettes_ = palettes;
            nextPortion_ = 0;
            busy_ = threads_.size();
            ++round_;
        }
        begin_.notify_all();
        takePortions(posers_.front());
        std::unique_lock lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
    }

private:
    static constexpr std::size_t kPortion = 64;  // characters

    void takePortions(FastPoser& poser) {
        for (;;) {
            const std::size_t first = kPortion * nextPortion_++;
            if (first >= seconds_.size()) return;
            const std::size_t count = std::min(kPortion, seconds_.size() - first);
            poser.pose(seconds_.subspan(first, count),
                       palettes_.subspan(first * paletteSize(), count * paletteSize()));
        }
    }

    void workOn(std::size_t index) {
        std::unique_lock lock(mutex_);
        for (std::size_t seen = 0;;) {
            begin_.wait(lock, [&] { return ends_ || round_ != seen; });
            if (ends_) return;
            seen = round_;
            lock.unlock();
            takePortions(posers_[index]);
            lock.lock();
            if (--busy_ == 0) done_.notify_one();
        }
    }

    std::vector<FastPoser> posers_;  // one per thread; the first is the caller's
    std::mutex mutex_;               // of all below but nextPortion_
    std::condition_variable begin_, done_;
    std::span<const double> seconds_;
    std::span<JointRows> palettes_;
    std::atomic<std::size_t> nextPortion_{0};
    std::size_t busy_ = 0, round_ = 0;
    bool ends_ = false;
    std::vector<std::jthread> threads_;  // last, so that they end first
};

CrowdPoser::CrowdPoser(const FastPoser& poser, unsigned int threads)
    : workers_(
          std::make_unique<Workers>(poser, threads > 0 ? threads : std::thread::hardware_concurrency())) {}

CrowdPoser::~CrowdPoser() = default;

std::size_t CrowdPoser::paletteSize() const {
    return workers_->paletteSize();
}

void CrowdPoser::pose(std::span<const double> seconds, std::span<JointRows> palettes) {
    workers_->pose(seconds, palettes);
}

}  // namespace walkcycle
