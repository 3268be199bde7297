#pragma once

#include "gesture/model_file.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace steadyhand::bench {

using Models = std::vector<std::shared_ptr<const GestureModel>>;

inline constexpr std::array GESTURES{ "horizontal_drag", "vertical_drag", "tap", "zoom" };

inline std::string read_text(const std::string &path) {
	std::ifstream file(path);
	return { std::istreambuf_iterator<char>(file), {} };
}

/// Models of GESTURES from their files in the folder. If one cannot be read: none, and an error on stderr.
inline Models read_models(const std::string &folder) {
	Models models;
	for (const std::string gesture : GESTURES) {
		const std::string path = folder + "/" + gesture + ".gesture";
		const Result<GestureModel> model = parse_model(read_text(path), path);
		if (!model) {
			std::fprintf(stderr, "%s\n", model.error().c_str());
			return {};
		}
		models.push_back(std::make_shared<const GestureModel>(model.value()));
	}
	return models;
}

} // namespace steadyhand::bench
