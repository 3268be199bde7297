extends "support/editor_test.gd"
## The add-on's library in the editor.

const EXTENSION := "res://addons/steadyhand/steadyhand.gdextension"


# The engine may keep the old library in memory, and its signal connections lead into it.
func test_the_editor_does_not_reload_the_library() -> void:
	# expects one error: This GDExtension is not marked as 'reloadable'
	var status := GDExtensionManager.reload_extension(EXTENSION)
	check_equal(status, GDExtensionManager.LOAD_STATUS_FAILED, "the library stays as it is")
	check(GDExtensionManager.is_extension_loaded(EXTENSION), "it is still loaded")
