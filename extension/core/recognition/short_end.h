#pragma once

namespace steadyhand {

/// A gesture with a task that ends short of it: the hand stays there, or has turned back. Values are what is
/// shown, in amplitudes.
class ShortEnd {
public:
	/// No nearer to the start than this.
	static constexpr double NEAREST = 0.7;

	/// A gesture has begun.
	void begin(double t_s);
	/// At each step of it. is_seen: the hand is; is_sure: and has been for long enough to tell how far it
	/// came.
	void follow(double t_s, double value, bool is_seen, bool is_sure);

	/// As of the last step.
	[[nodiscard]] bool has_ended(double t_s) const;
	/// The furthest that a hand which was seen came.
	[[nodiscard]] double furthest() const { return furthest_; }

private:
	double value_ = 0.0;
	double stays_at_ = 0.0;
	double stays_since_s_ = 0.0;
	double furthest_ = 0.0;
};

} // namespace steadyhand
