// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/base/unlisted.h"
