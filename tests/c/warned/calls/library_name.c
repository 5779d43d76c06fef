/* A function of the program that has a name of the library's. */
#include <stdio.h>

int getline(char line[], int most); // warning: incompatible redeclaration of library function 'getline'

int getline(char line[], int most)
{
    return sprintf(line, "%d", most);
}

int main(void)
{
    char line[20];

    return getline(line, 20) != 2;
}
