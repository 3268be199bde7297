#include "register_types.h"

#include "degraded_source.h"
#include "gesture_format.h"
#include "gesture_hmm.h"
#include "gesture_model.h"
#include "gesture_task.h"
#include "gesture_trainer.h"
#include "hand_frame.h"
#include "hand_tracker.h"
#include "haptic_clip.h"
#include "haptic_clip_format.h"
#include "haptic_device_profile.h"
#include "haptic_effect.h"
#include "haptic_stream.h"
#include "haptic_synth.h"
#include "leap_source.h"
#include "liberty_source.h"
#include "lsl_outlet.h"
#include "motion_metrics.h"
#include "recorded_source.h"
#include "recorded_track.h"
#include "script_source.h"
#include "synthetic_source.h"
#include "tracker_alignment.h"
#include "tracking_survey.h"
#include "trial_set.h"
#include "xr_source.h"

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/resource_saver.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

/// Pages of the class reference, then null; written by the build from extension/doc_classes.
extern const char *const STEADYHAND_DOC_XML[];

namespace {

using namespace godot;

/// The engine's editor_help_load_xml_from_utf8_chars; its type's name differs between Godot's versions.
using LoadHelpPage = void (*)(const char *p_xml);
LoadHelpPage load_help_page = nullptr;

/// Held by the engine's lists while the library is loaded. Plain pointers, since a static Ref would outlive
/// the engine.
struct Formats {
	Ref<GestureFormatLoader> gesture_loader;
	Ref<GestureFormatSaver> gesture_saver;
	Ref<HapticClipFormatLoader> clip_loader;
	Ref<HapticClipFormatSaver> clip_saver;
};
Formats *formats = nullptr;

void add_formats() {
	formats = new Formats;
	formats->gesture_loader.instantiate();
	formats->gesture_saver.instantiate();
	formats->clip_loader.instantiate();
	formats->clip_saver.instantiate();
	ResourceLoader::get_singleton()->add_resource_format_loader(formats->gesture_loader);
	ResourceLoader::get_singleton()->add_resource_format_loader(formats->clip_loader);
	ResourceSaver::get_singleton()->add_resource_format_saver(formats->gesture_saver);
	ResourceSaver::get_singleton()->add_resource_format_saver(formats->clip_saver);
}

void remove_formats() {
	ResourceLoader::get_singleton()->remove_resource_format_loader(formats->gesture_loader);
	ResourceLoader::get_singleton()->remove_resource_format_loader(formats->clip_loader);
	ResourceSaver::get_singleton()->remove_resource_format_saver(formats->gesture_saver);
	ResourceSaver::get_singleton()->remove_resource_format_saver(formats->clip_saver);
	delete formats;
	formats = nullptr;
}

void initialise(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(GestureModel);
		GDREGISTER_CLASS(TrialSet);
		GDREGISTER_CLASS(RecordedTrack);
		GDREGISTER_CLASS(GestureTrainer);
		GDREGISTER_CLASS(MotionMetrics);
		GDREGISTER_CLASS(TrackingSurvey);
		GDREGISTER_CLASS(HandFrame);
		GDREGISTER_VIRTUAL_CLASS(HandSource);
		GDREGISTER_CLASS(ScriptSource);
		GDREGISTER_CLASS(RecordedSource);
		GDREGISTER_CLASS(SyntheticSource);
		GDREGISTER_CLASS(XRSource);
		GDREGISTER_CLASS(LeapSource);
		GDREGISTER_CLASS(LibertySource);
		GDREGISTER_CLASS(DegradedSource);
		GDREGISTER_CLASS(HandTracker);
		GDREGISTER_CLASS(TrackerAlignment);
		GDREGISTER_CLASS(LslOutlet);
		GDREGISTER_CLASS(GestureTask);
		GDREGISTER_CLASS(GestureHMM);
		GDREGISTER_ABSTRACT_CLASS(HapticEffect);
		GDREGISTER_CLASS(SpringEffect);
		GDREGISTER_CLASS(InertialViscousEffect);
		GDREGISTER_CLASS(ImpulseEffect);
		GDREGISTER_CLASS(CustomEffect);
		GDREGISTER_CLASS(HapticClip);
		GDREGISTER_CLASS(HapticDeviceProfile);
		GDREGISTER_CLASS(HapticSynth);
		GDREGISTER_INTERNAL_CLASS(HapticStreamPlayback);
		GDREGISTER_INTERNAL_CLASS(HapticStream);
		GDREGISTER_INTERNAL_CLASS(GestureFormatLoader);
		GDREGISTER_INTERNAL_CLASS(GestureFormatSaver);
		GDREGISTER_INTERNAL_CLASS(HapticClipFormatLoader);
		GDREGISTER_INTERNAL_CLASS(HapticClipFormatSaver);
		add_formats();
	} else if (p_level == MODULE_INITIALIZATION_LEVEL_EDITOR && load_help_page != nullptr) {
		for (const char *const *page = STEADYHAND_DOC_XML; *page != nullptr; ++page) {
			load_help_page(*page);
		}
	}
}

void terminate(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		HapticStreamPlayback::wait_for_last_mix();
		remove_formats();
	}
}

} // namespace

GDExtensionBool steadyhand_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	load_help_page =
			reinterpret_cast<LoadHelpPage>(p_get_proc_address("editor_help_load_xml_from_utf8_chars"));
	const GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialise);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
