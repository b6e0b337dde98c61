// Counters of what a ray costs. Without STATISTICS they are not there.
#if STATISTICS
layout(location = 1) out uvec4 out_counts;  // field evaluations, those of DVR, crossings, 1 if the box is hit
uvec4 counts = uvec4(0u);
#define COUNT_SAMPLE ++counts.x
#define COUNT_CROSSING ++counts.z
#else
#define COUNT_SAMPLE
#define COUNT_CROSSING
#endif
