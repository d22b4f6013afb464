// Index of an invocation in a dispatch whose workgroups are spread over x and y (gpu::groupCount).
uint workgroupIndex() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint linearIndex() { return workgroupIndex() * gl_WorkGroupSize.x + gl_LocalInvocationIndex; }
