/* Two variables of one name in one scope. */
int main(void)
{
    int count = 1;
    int count = 2; // error: redefinition
    return count;
}
