/* load_library LIBRARY: loads the extension's Windows library and calls its entry with a stub for an engine.
 *
 * An engine without a single function is refused; one that has them all is accepted, and nothing is called before the
 * engine asks for it. Prints a line for each and ends with 0 if both are so.
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <windows.h>

typedef void (*Function)(void);
typedef Function (*FindFunction)(const char *name);

/* GDExtensionInitialization of gdextension_interface.h */
typedef struct {
	int32_t minimum_level;
	void *user;
	void (*initialize)(void *user, int32_t level);
	void (*deinitialize)(void *user, int32_t level);
} Initialization;

typedef uint8_t (*Entry)(FindFunction find, void *library, Initialization *initialization);

static int called;

static void note_call(void) {
	called++;
}

static Function find_none(const char *name) {
	(void)name;
	return NULL;
}

static Function find_all(const char *name) {
	(void)name;
	return note_call;
}

int main(int argc, char **argv) {
	const HMODULE library = argc == 2 ? LoadLibraryA(argv[1]) : NULL;
	if (library == NULL) {
		printf("not loaded: error %lu\n", GetLastError());
		return 1;
	}
	Entry entry;
	const FARPROC found = GetProcAddress(library, "steadyhand_init");
	memcpy(&entry, &found, sizeof(entry));
	if (entry == NULL) {
		printf("no steadyhand_init\n");
		return 1;
	}
	Initialization initialization = { 0, NULL, NULL, NULL };
	const int refused = entry(find_none, NULL, &initialization) == 0;
	printf("an engine without functions: %s\n", refused ? "refused" : "accepted");
	const int accepted = entry(find_all, NULL, &initialization) != 0 && initialization.initialize != NULL &&
			initialization.deinitialize != NULL;
	printf("an engine with all functions: %s, %d calls\n", accepted ? "accepted" : "refused", called);
	return refused && accepted && called == 0 ? 0 : 1;
}
