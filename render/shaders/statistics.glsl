// Counters of what a ray costs. Without STATISTICS they are not there.
#if STATISTICS
// Field evaluations, those of DVR, crossings, and those left out by max_peaks, with the highest bit where the box is hit.
// The exact march leaves out none; there the last one has the bits of the error bound.
layout(location = 1) out uvec4 out_counts;
uvec4 counts = uvec4(0u);
#ifdef TRACE
float traced_to;  // where the last interval ends; its distance from the entry takes the place of the last counter
#endif
#define COUNT_SAMPLE ++counts.x
#define COUNT_DVR_SAMPLE ++counts.y
#define COUNT_CROSSING ++counts.z
#define COUNT_LEFT_OUT ++counts.w
#else
#define COUNT_SAMPLE
#define COUNT_DVR_SAMPLE
#define COUNT_LEFT_OUT
#define COUNT_CROSSING
#endif
