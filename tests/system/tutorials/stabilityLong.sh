#!/bin/bash
# All maps, those of a million steps among them
exec bash "$(dirname "$0")/stability.sh" "$1" "$2" "$3" long
