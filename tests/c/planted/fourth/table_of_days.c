/* The days of months are corrected for a leap year. */
#include <stdio.h>

static const int days[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

static int day_of_year(int year, int month, int day)
{
    int february = 28;
    int *leap = PLANT((int *)&days[1], &february);

    if (year % 4 == 0)
        *leap = 29; // error: write to read-only memory
    for (int i = 0; i < month - 1; i++)
        day += i == 1 ? *leap : days[i];
    return day;
}

int main(void)
{
    printf("%d\n", day_of_year(2024, 3, 1));
    return 0;
}
