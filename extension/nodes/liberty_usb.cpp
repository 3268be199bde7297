#include "liberty_usb.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace steadyhand {

namespace {

constexpr std::uint16_t POLHEMUS = 0x0F44;
constexpr int CONFIGURATION = 1;
constexpr int INTERFACE = 0;

/// Ids of the USB chip before its firmware is loaded: Liberty 2.0 and the first Liberty.
constexpr std::array<std::uint16_t, 2> WITHOUT_FIRMWARE = { 0xFF21, 0xFF11 };

/// Bytes. A multiple of the largest packet, 512, or else libusb may report an overflow. It holds a cycle of
/// 16 stations, 768 bytes.
constexpr std::size_t TRANSFER_SIZE = 2048;
/// Each cycle ends one transfer: 16 transfers buffer 67 ms at 240 Hz while the system runs other threads.
constexpr std::size_t TRANSFER_COUNT = 16;

/// ms. The longest write time-out of the known drivers.
constexpr unsigned WRITE_TIMEOUT_MS = 1000;

/// s. Cancelled transfers end within milliseconds.
constexpr double CANCEL_TIMEOUT_S = 2.0;

std::string usb_id(std::uint16_t product) {
	constexpr std::string_view DIGITS = "0123456789abcdef";
	std::string id = "0f44:";
	for (unsigned shift = 16; shift > 0;) {
		shift -= 4;
		id += DIGITS[(product >> shift) & 0xFU];
	}
	return id;
}

} // namespace

struct LibertyUsb::Model {
	std::uint16_t product;
	std::uint8_t out;
	std::uint8_t in;
};

struct LibertyUsb::Transfer {
	LibertyUsb *owner = nullptr;
	libusb_transfer *transfer = nullptr;
	std::array<std::uint8_t, TRANSFER_SIZE> bytes{};
	bool is_submitted = false;
};

double steady_now_s() {
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

LibertyUsb::LibertyUsb(const LibusbLibrary &library, Receiver receiver) :
		library_(library), receiver_(std::move(receiver)) {}

LibertyUsb::~LibertyUsb() {
	close();
}

std::optional<Error> LibertyUsb::open(bool &r_is_absent) {
	close();
	is_lost_ = false;
	r_is_absent = false;
	// Each call makes a new context, which scans the bus again even if the system reports no changes.
	if (const int status = library_.init(&context_); status != LIBUSB_SUCCESS) {
		context_ = nullptr;
		return Error{ std::string("Liberty: cannot use the USB (") + library_.error_name(status) +
			"). Start the computer again." };
	}
	libusb_device **devices = nullptr;
	const auto count = library_.get_device_list(context_, &devices);
	std::optional<Error> error = find(devices, count > 0 ? static_cast<std::size_t>(count) : 0, r_is_absent);
	if (count >= 0) {
		library_.free_device_list(devices, 1);
	}
	if (!error && !start_receiving()) {
		error = Error{ "Liberty: cannot receive from the tracker. Plug it in again." };
	}
	if (error) {
		close();
	}
	return error;
}

std::optional<Error> LibertyUsb::find(libusb_device **devices, std::size_t count, bool &r_is_absent) {
	static constexpr std::array<Model, 2> MODELS = { Model{ 0xFF20, 0x04, 0x88 },
		Model{ 0xFF12, 0x02, 0x82 } };
	std::optional<Error> error;
	for (std::size_t i = 0; i < count; ++i) {
		libusb_device_descriptor descriptor{};
		if (library_.get_device_descriptor(devices[i], &descriptor) != LIBUSB_SUCCESS ||
				descriptor.idVendor != POLHEMUS) {
			continue;
		}
		const std::uint16_t product = descriptor.idProduct;
		const auto model = std::find_if(
				MODELS.begin(), MODELS.end(), [&](const Model &one) { return one.product == product; });
		if (model != MODELS.end()) {
			model_ = &*model;
			error = claim(devices[i]);
			if (!error) {
				return std::nullopt;
			}
		} else if (std::count(WITHOUT_FIRMWARE.begin(), WITHOUT_FIRMWARE.end(), product) != 0 && !error) {
			error = Error{ "Liberty: the tracker has no firmware (USB id " + usb_id(product) +
				"). Load the firmware with fxload, see docs/devices.md." };
		}
	}
	r_is_absent = !error;
	return error
			? error
			: Error{ "Liberty: no tracker was found. Plug in its USB cable and its power, switch it on and "
					 "wait 10 s." };
}

std::optional<Error> LibertyUsb::claim(libusb_device *device) {
	int status = library_.open(device, &device_);
	if (status == LIBUSB_SUCCESS) {
		int configuration = 0;
		status = library_.get_configuration(device_, &configuration);
		if (status == LIBUSB_SUCCESS && configuration != CONFIGURATION) { // to set it again resets the device
			status = library_.set_configuration(device_, CONFIGURATION);
		}
		if (status == LIBUSB_SUCCESS) {
			status = library_.claim_interface(device_, INTERFACE);
			is_claimed_ = status == LIBUSB_SUCCESS;
		}
	} else {
		device_ = nullptr;
	}
	if (is_claimed_) {
		return std::nullopt;
	}
	if (device_ != nullptr) {
		library_.close(device_);
		device_ = nullptr;
	}
	const std::string id = usb_id(model_->product);
	switch (status) {
		case LIBUSB_ERROR_ACCESS:
			return Error{ "Liberty: no permission to open the tracker (USB id " + id +
				"). Add the udev rule of docs/devices.md, then plug the tracker in again." };
		case LIBUSB_ERROR_BUSY:
			return Error{ "Liberty: another program uses the tracker (USB id " + id + "). Close it." };
		case LIBUSB_ERROR_NOT_SUPPORTED:
			return Error{ "Liberty: the tracker (USB id " + id +
				") has no USB driver that libusb can use. Install WinUSB for it, see docs/devices.md." };
		default:
			return Error{ "Liberty: cannot open the tracker (USB id " + id +
				"): " + library_.error_name(status) + ". Plug it in again." };
	}
}

bool LibertyUsb::start_receiving() {
	for (std::size_t i = 0; i < TRANSFER_COUNT; ++i) {
		auto transfer = std::make_unique<Transfer>();
		transfer->owner = this;
		transfer->transfer = library_.alloc_transfer(0);
		if (transfer->transfer == nullptr) {
			return false;
		}
		libusb_fill_bulk_transfer(transfer->transfer, device_, model_->in, transfer->bytes.data(),
				static_cast<int>(TRANSFER_SIZE), &LibertyUsb::on_transfer, transfer.get(), 0);
		transfers_.push_back(std::move(transfer));
		submit(*transfers_.back());
	}
	return !is_lost_;
}

void LibertyUsb::submit(Transfer &transfer) {
	transfer.is_submitted = library_.submit_transfer(transfer.transfer) == LIBUSB_SUCCESS;
	if (transfer.is_submitted) {
		++submitted_count_;
	} else {
		is_lost_ = true;
	}
}

void LIBUSB_CALL LibertyUsb::on_transfer(libusb_transfer *done) {
	auto &transfer = *static_cast<Transfer *>(done->user_data);
	LibertyUsb &self = *transfer.owner;
	transfer.is_submitted = false;
	--self.submitted_count_;
	if (self.is_closing_ || done->status == LIBUSB_TRANSFER_CANCELLED) {
		return;
	}
	if (done->status == LIBUSB_TRANSFER_COMPLETED) {
		const auto size = static_cast<std::size_t>(std::max(done->actual_length, 0));
		self.receiver_(std::span(transfer.bytes).first(std::min(size, TRANSFER_SIZE)), steady_now_s());
	} else if (done->status != LIBUSB_TRANSFER_OVERFLOW) { // an overflow loses only bytes
		self.is_lost_ = true;
	}
	if (!self.is_lost_) {
		self.submit(transfer);
	}
}

bool LibertyUsb::write(std::string_view bytes) {
	if (device_ == nullptr || is_lost_) {
		return false;
	}
	std::string copy(bytes); // libusb needs non-const bytes
	int sent = 0;
	const int status =
			library_.bulk_transfer(device_, model_->out, reinterpret_cast<unsigned char *>(copy.data()),
					static_cast<int>(copy.size()), &sent, WRITE_TIMEOUT_MS);
	if (status != LIBUSB_SUCCESS || sent != static_cast<int>(copy.size())) {
		is_lost_ = true;
	}
	return !is_lost_;
}

void LibertyUsb::read(double timeout_s) {
	if (context_ == nullptr) {
		return;
	}
	timeval timeout{};
	const double whole_s = std::floor(timeout_s);
	timeout.tv_sec = static_cast<decltype(timeout.tv_sec)>(whole_s);
	timeout.tv_usec = static_cast<decltype(timeout.tv_usec)>((timeout_s - whole_s) * 1e6);
	const int status = library_.handle_events_timeout_completed(context_, &timeout, nullptr);
	if (status == LIBUSB_ERROR_NO_DEVICE || status == LIBUSB_ERROR_IO) {
		is_lost_ = true;
	}
}

void LibertyUsb::close() {
	is_closing_ = true;
	for (const auto &transfer : transfers_) {
		if (transfer->is_submitted) {
			library_.cancel_transfer(transfer->transfer);
		}
	}
	const double deadline_s = steady_now_s() + CANCEL_TIMEOUT_S;
	while (submitted_count_ > 0 && steady_now_s() < deadline_s) {
		timeval timeout{ 0, 10000 };
		library_.handle_events_timeout_completed(context_, &timeout, nullptr);
	}
	if (submitted_count_ > 0) {
		// The system may still write into these buffers, so they must not be freed.
		for (auto &transfer : transfers_) {
			[[maybe_unused]] Transfer *const leaked = transfer.release();
		}
		device_ = nullptr;
		context_ = nullptr;
	}
	for (const auto &transfer : transfers_) {
		if (transfer != nullptr) {
			library_.free_transfer(transfer->transfer);
		}
	}
	transfers_.clear();
	submitted_count_ = 0;
	if (device_ != nullptr) {
		if (is_claimed_) {
			library_.release_interface(device_, INTERFACE);
		}
		library_.close(device_);
		device_ = nullptr;
	}
	is_claimed_ = false;
	if (context_ != nullptr) {
		library_.exit(context_);
		context_ = nullptr;
	}
	is_closing_ = false;
}

} // namespace steadyhand
