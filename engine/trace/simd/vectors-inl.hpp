// Left until engine/light includes lanes-inl.hpp itself.
#include "engine/real/lanes-inl.hpp"
