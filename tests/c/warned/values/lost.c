/* Implicit conversions that change a number. */
#include <stdio.h>

#define THIRD (1 / 3)

int big = 3000000000; // warning: conversion from 'long long' to 'int' changes 3000000000 to -1294967296
//        ^
char small = 300; // warning: conversion from 'int' to 'char' changes 300 to 44
unsigned char negative = -200; // warning: conversion from 'int' to 'unsigned char' changes -200 to 56
int huge = 1e10; // warning: conversion from 'double' to 'int' changes 1e+10 to 2147483647
int product = 70000 * 70000; // warning: overflow in the constant expression: 4900000000 is outside
//            ^
char byte = 0xff, letter = '\xe4';
unsigned all = -1, high = 0x80000000;
int bits = 0xffffffff, least = -2147483647 - 1;
double half = 1 / 2; // warning: the fraction of this division of integers is lost: its value is 0
//            ^
double two = 4 / 2, cast = (double)(1 / 2), sizes = sizeof product / sizeof byte;

static double mean(int sum, int count)
{
    double first = sum / count; // warning: the fraction of this division of integers is lost
    first += (double)sum / count;
    first *= 4 / 3; // warning: the fraction of this division of integers is lost: its value is 1
    if (first > THIRD) // warning: the fraction of this division of integers is lost: its value is 0
        first = (double)(sum / count);
    return sum / count; // warning: the fraction of this division of integers is lost
}

int main(void)
{
    printf("%g %g\n", mean(7, 2), half + two + cast + sizes);
    return big + small + negative + huge + byte + letter + (int)all + (int)high + bits + least;
}
