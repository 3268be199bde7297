// liberty_sim [OPTION...] PROGRAM [ARGUMENT...]: runs PROGRAM on a USB with a simulated Polhemus Liberty.
//
// Run it through umockdev-wrapper. PROGRAM inherits the environment; its exit status is the simulator's.
//
//   --rate HZ            measure at HZ, whatever the computer sets
//   --split              cut transfers at odd places
//   --garbage            random bytes between records
//   --flip               report mirror images for a second of each round
//   --silent             answer nothing
//   --refuse LETTER      refuse the commands that start with LETTER
//   --streaming          stream from the start, as after a crash
//   --stations N         N sensors (default 1)
//   --unplug-after S     unplug the tracker after S seconds of its first stream
//   --replug-after S     plug it in again S seconds after PROGRAM has noticed that
//   --no-device          nothing is plugged in
//   --firmware-missing   the USB chip without its firmware
//   --no-permission      the tracker may not be opened
//   --busy               another program has claimed it
//   --print-commands     print all commands of the computer at the end, and how many frames it fetched too
//   late

#include "simulated_usb.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

bool read_options(char **&r_word, SimulatedUsbOptions &r_options) {
	for (; *r_word != nullptr && std::string_view(*r_word).starts_with("--"); ++r_word) {
		const std::string_view name = *r_word;
		const auto number = [&r_word] { return *++r_word != nullptr ? std::strtod(*r_word, nullptr) : 0.0; };
		SimulatedFaults &faults = r_options.faults;
		if (name == "--rate") {
			faults.rate_hz = number();
		} else if (name == "--refuse") {
			faults.refused = *++r_word != nullptr ? **r_word : '\0';
		} else if (name == "--stations") {
			faults.station_count = static_cast<int>(number());
		} else if (name == "--unplug-after") {
			r_options.unplug_s = number();
		} else if (name == "--replug-after") {
			r_options.replug_s = number();
		} else if (name == "--split") {
			faults.split = true;
		} else if (name == "--garbage") {
			faults.garbage = true;
		} else if (name == "--flip") {
			faults.flip = true;
		} else if (name == "--silent") {
			faults.silent = true;
		} else if (name == "--streaming") {
			faults.streaming = true;
		} else if (name == "--no-device") {
			r_options.no_device = true;
		} else if (name == "--firmware-missing") {
			r_options.firmware_missing = true;
		} else if (name == "--no-permission") {
			r_options.no_permission = true;
		} else if (name == "--busy") {
			r_options.busy = true;
		} else if (name == "--print-commands") {
			r_options.print_commands = true;
		} else {
			return false;
		}
		if (*r_word == nullptr) {
			return false;
		}
	}
	return *r_word != nullptr;
}

} // namespace

int main(int, char **argv) {
	SimulatedUsbOptions options;
	char **word = argv + 1;
	if (!read_options(word, options)) {
		std::fputs("liberty_sim [OPTION...] PROGRAM [ARGUMENT...]: the head of liberty_sim.cpp lists the "
				   "options\n",
				stderr);
		return 2;
	}
	return SimulatedUsb(options).run(word);
}
