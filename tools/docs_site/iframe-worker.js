// A browser starts no Worker from file://, and the search needs one. There it runs in a hidden frame instead.
if (location.protocol === "file:") {
	window.Worker = class extends EventTarget {
		constructor(url) {
			super();
			this.waiting = [];
			this.frame = document.createElement("iframe");
			this.frame.hidden = true;
			document.body.append(this.frame);
			const inside = this.frame.contentWindow;
			inside.document.open();
			inside.document.write("<!doctype html><title>search</title>");
			inside.document.close();
			// The worker's script answers by postMessage(), as in a Worker.
			inside.postMessage = (data) => this.dispatchEvent(new MessageEvent("message", { data }));
			const script = inside.document.createElement("script");
			script.src = url;
			script.onload = () => {
				this.isLoaded = true;
				this.waiting.forEach((data) => this.deliver(data));
			};
			script.onerror = () => this.dispatchEvent(new Event("error"));
			inside.document.head.append(script);
		}

		postMessage(data) {
			if (this.isLoaded) {
				this.deliver(data);
			} else {
				this.waiting.push(data);
			}
		}

		deliver(data) {
			const inside = this.frame.contentWindow;
			inside.dispatchEvent(new inside.MessageEvent("message", { data }));
		}

		terminate() {
			this.frame.remove();
		}
	};
}
