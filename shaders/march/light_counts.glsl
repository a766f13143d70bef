// How many lights of each kind a program draws; its builder replaces this text (raymarch/lights.h).
const int kLightFields = 1;
const int kDiscs = 1;    // bit i: field i is a disc
const int kVolumes = 0;  // bit i: field i has a value at every sample
const int kSuns = 1;
