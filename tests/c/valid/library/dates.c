/* The calendar: from numbers to dates and back, and as text. */
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void show(time_t time)
{
    struct tm *date = gmtime(&time);

    printf("%ld: %d-%d-%d %d:%d:%d %d %d %d\n", (long)time, date->tm_year, date->tm_mon,
           date->tm_mday, date->tm_hour, date->tm_min, date->tm_sec, date->tm_wday,
           date->tm_yday, date->tm_isdst);
}

static void normalise(int year, int month, int day, int hour, int minute, int second)
{
    struct tm date;

    memset(&date, 0, sizeof date);
    date.tm_year = year;
    date.tm_mon = month;
    date.tm_mday = day;
    date.tm_hour = hour;
    date.tm_min = minute;
    date.tm_sec = second;
    printf("%ld", (long)timegm(&date));
    printf(" %d/%d/%d %d:%d:%d %d %d\n", date.tm_year, date.tm_mon, date.tm_mday, date.tm_hour,
           date.tm_min, date.tm_sec, date.tm_wday, date.tm_yday);
}

int main(void)
{
    static const char *const formats[] = {
        "%a %A %b %B %h", "%c", "%C %d %D %e", "%F %g %G %V", "%H %I %k %l %M %m", "%j %n%t%p %P",
        "%r %R %S %T", "%u %U %w %W", "%x %X %y %Y", "%z %%", "%Ec %Od %EY", "%s",
    };
    static const long times[] = {
        0, -1, 1, 86399, 86400, 951782399, 951782400, 951868800, 978307199, 1000000000,
        1078099200, 2147483647, -2147483647, -86400, 1230768000, 1609459199,
    };
    char text[200];
    time_t when;
    size_t i, k;

    setenv("TZ", "UTC", 1);
    for (i = 0; i < sizeof times / sizeof *times; i++)
        show(times[i]);
    normalise(100, 1, 30, 0, 0, 0);
    normalise(99, 14, 1, 0, 0, -1);
    normalise(70, 0, 1, 0, 0, 100000);
    normalise(105, -1, -400, -5, 90, -90);
    normalise(80, 25, 31, 23, 59, 61);
    for (k = 0; k < sizeof times / sizeof *times; k += 4)
        for (i = 0; i < sizeof formats / sizeof *formats; i++) {
            when = times[k];
            strftime(text, sizeof text, formats[i], gmtime(&when));
            puts(text);
        }
    for (i = 0; i < 90; i++) {    /* the first and last days of thirty years */
        when = 86400L * (365 * (i / 3) + i / 12 - 1 + i % 3);
        strftime(text, sizeof text, "%G-%V-%u %U %W", gmtime(&when));
        puts(text);
    }
    when = 1234567890;
    printf("%d %d\n", (int)strftime(text, 10, "%Y-%m-%d", gmtime(&when)),
           (int)strftime(text, 11, "%Y-%m-%d", gmtime(&when)));
    printf("%s%s", ctime(&when), asctime(gmtime(&when)));
    printf("%.1f\n", difftime(10, 3));
    return 0;
}
