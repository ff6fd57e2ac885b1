// SPDX-License-Identifier: MIT
#include "evenmesh/cost/wrong.h"
