/* Two enumeration constants of one name. */
enum side { LEFT, RIGHT };
enum turn { LEFT }; // error: redefinition

int main(void)
{
    return 0;
}
