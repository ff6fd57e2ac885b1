// SPDX-License-Identifier: MIT
#pragma once

#include "wrong.h"
