#pragma once

#include "base/result.h"
#include "libusb_library.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace steadyhand {

/// A Liberty on the USB, as a stream of bytes in both directions. Only for one thread.
class LibertyUsb {
public:
	/// Bytes of one transfer, and their arrival on std::chrono::steady_clock, s. Called inside read() and
	/// write().
	using Receiver = std::function<void(std::span<const std::uint8_t> bytes, double host_s)>;

	/// `library` must outlive this object.
	LibertyUsb(const LibusbLibrary &library, Receiver receiver);
	~LibertyUsb(); ///< as close()
	LibertyUsb(const LibertyUsb &) = delete;
	LibertyUsb &operator=(const LibertyUsb &) = delete;

	/// Finds and claims the tracker, and starts to receive. The error says what to do. `r_is_absent`: no
	/// tracker was found.
	[[nodiscard]] std::optional<Error> open(bool &r_is_absent);

	/// False if not all bytes were sent; the tracker is then lost.
	bool write(std::string_view bytes);

	/// Waits for bytes, `timeout_s` at most.
	void read(double timeout_s);

	/// The tracker was unplugged or fails; no more data follows.
	[[nodiscard]] bool is_lost() const { return is_lost_; }

	/// Ends all transfers and releases the tracker. May be called at any time, also twice.
	void close();

private:
	struct Transfer;
	struct Model;

	static void LIBUSB_CALL on_transfer(libusb_transfer *transfer);
	std::optional<Error> find(libusb_device **devices, std::size_t count, bool &r_is_absent);
	std::optional<Error> claim(libusb_device *device);
	bool start_receiving();
	void submit(Transfer &transfer);

	const LibusbLibrary &library_;
	Receiver receiver_;
	const Model *model_ = nullptr;
	libusb_context *context_ = nullptr;
	libusb_device_handle *device_ = nullptr;
	std::vector<std::unique_ptr<Transfer>> transfers_;
	std::size_t submitted_count_ = 0;
	bool is_claimed_ = false;
	bool is_closing_ = false;
	bool is_lost_ = false;
};

/// Now on std::chrono::steady_clock, s.
[[nodiscard]] double steady_now_s();

} // namespace steadyhand
