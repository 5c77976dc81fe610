// Texts of the page by which its tests recognize a state.
export const kWindowEnded = 'This window has ended';
export const kNoProgram = 'No connection to the window’s program';
export const kNoData = 'No data from the robot';
export const kPoseUnknown = 'its pose is unknown';
export const kStandingStill = 'Standing still';
export const kNothingRuns = 'Nothing runs.';
export const kNotChecked = 'Checks computer, port, board and servos. Nothing moves; servo power is switched on if it is off.';
export const kDoctorRuns = 'Some seconds:';
