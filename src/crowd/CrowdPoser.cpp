#include "walkcycle/crowd/CrowdPoser.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "crowd/FastPoser.h"

namespace walkcycle {

class CrowdPoser::Workers {
public:
    Workers(const FastPoser& poser, unsigned int threads)
        : posers_(std::clamp(threads, 1u, kMostThreads), poser) {
        for (std::size_t i = 1; i < posers_.size(); ++i)
            threads_.emplace_back([this, i](const std::stop_token& stop) { work(stop, posers_[i]); });
    }

    const FastPoser& poser() const { return posers_.front(); }

    void pose(std::span<const double> seconds, std::span<JointRows> palettes) {
        if (threads_.empty() || seconds.size() <= kPortion) return posers_.front().pose(seconds, palettes);
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
    static constexpr std::size_t kPortion = 64;        // characters
    static constexpr unsigned int kMostThreads = 256;  // each has a copy of the tables

    void takePortions(FastPoser& poser) {
        const std::size_t size = poser.paletteSize();
        for (;;) {
            const std::size_t first = kPortion * nextPortion_++;
            if (first >= seconds_.size()) return;
            const std::size_t count = std::min(kPortion, seconds_.size() - first);
            poser.pose(seconds_.subspan(first, count), palettes_.subspan(first * size, count * size));
        }
    }

    void work(const std::stop_token& stop, FastPoser& poser) {
        std::unique_lock lock(mutex_);
        for (std::size_t seen = 0; begin_.wait(lock, stop, [&] { return round_ != seen; });) {
            seen = round_;
            lock.unlock();
            takePortions(poser);
            lock.lock();
            if (--busy_ == 0) done_.notify_one();
        }
    }

    std::vector<FastPoser> posers_;  // one per thread; the first is the caller's
    std::mutex mutex_;               // guards the members below, except nextPortion_ and threads_
    std::condition_variable_any begin_;
    std::condition_variable done_;
    std::span<const double> seconds_;
    std::span<JointRows> palettes_;
    std::atomic<std::size_t> nextPortion_{0};
    std::size_t busy_ = 0, round_ = 0;
    std::vector<std::jthread> threads_;  // the last member: destroyed first, before what the threads use
};

CrowdPoser::CrowdPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin,
                       unsigned int threads)
    : workers_(std::make_unique<Workers>(FastPoser(skeleton, animation, skin),
                                         threads > 0 ? threads : std::thread::hardware_concurrency())) {}

CrowdPoser::~CrowdPoser() = default;
CrowdPoser::CrowdPoser(CrowdPoser&&) noexcept = default;
CrowdPoser& CrowdPoser::operator=(CrowdPoser&&) noexcept = default;

std::size_t CrowdPoser::paletteSize() const {
    return workers_->poser().paletteSize();
}

double CrowdPoser::lengthInSeconds() const {
    return workers_->poser().lengthInSeconds();
}

void CrowdPoser::pose(std::span<const double> seconds, std::span<JointRows> palettes) {
    workers_->pose(seconds, palettes);
}

void CrowdPoser::poseOne(double seconds, std::span<JointRows> palette) {
    workers_->pose({&seconds, 1}, palette);
}

}  // namespace walkcycle
